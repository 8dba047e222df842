"""A headless Chromium that opens pages from disk or from this machine, without a network."""

import shutil

MISSING = None
try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError as error:
    MISSING = f"no browser to test with: {error} (scripts/setup.sh installs python3-selenium, chromium and chromium-driver)"
if not MISSING and not (shutil.which("chromium") and shutil.which("chromedriver")):
    MISSING = "no browser to test with: chromium or chromedriver is missing (scripts/setup.sh installs them)"


def key(name):
    """A key by Selenium's name, e.g. ARROW_LEFT."""
    from selenium.webdriver.common.keys import Keys

    return getattr(Keys, name)


class Browser:
    """Opens pages, one after the other."""

    def __init__(self):
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ("headless=new", "no-sandbox", "disable-gpu", "disable-dev-shm-usage", "host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"):
            options.add_argument("--" + argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.driver.set_page_load_timeout(50)

    def close(self):
        self.driver.quit()

    def open(self, page, width=1400, height=900, scheme="light"):
        """A file or an address, until its charts are drawn, or it says why not. Width and height are in pixels."""
        # A window has a least width; a telephone is narrower.
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        # Without smooth scrolling: what is clicked stays where it was found.
        features = {"prefers-color-scheme": scheme, "prefers-reduced-motion": "reduce"}
        self.command("Emulation.setEmulatedMedia", features=[{"name": name, "value": value} for name, value in features.items()])
        self.driver.get(page if isinstance(page, str) else page.resolve().as_uri())
        self.wait("return document.documentElement.dataset.ready === 'yes' || !document.getElementById('trouble').hidden")

    def command(self, name, **parameters):
        return self.driver.execute_cdp_cmd(name, parameters)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, script, seconds=45):
        """Until the script returns something true, which is returned."""
        return WebDriverWait(self.driver, seconds, poll_frequency=0.1).until(lambda _: self.run(script))

    def find(self, selector):
        return self.driver.find_element("css selector", selector)

    def show(self, selector):
        """The element, in the middle of the window."""
        element = self.find(selector)
        self.run("arguments[0].scrollIntoView({ block: 'center', behavior: 'instant' })", element)
        return element

    def complaints(self):
        """Warnings and errors in the console since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("WARNING", "SEVERE")]
