"""A headless Chromium that opens pages from disk, without a network."""

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


class Browser:
    """Opens one page at a width in pixels; dark or light."""

    def __init__(self, page, width=1400, height=900, dark=False):
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ("headless=new", "no-sandbox", "disable-gpu", "disable-dev-shm-usage", "host-resolver-rules=MAP * ~NOTFOUND"):
            options.add_argument("--" + argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.driver.set_page_load_timeout(50)
        # A window has a least width; a telephone is narrower.
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.scheme("dark" if dark else "light")
        self.driver.get(page.resolve().as_uri())
        self.wait("return document.documentElement.dataset.ready === 'yes' || !document.getElementById('trouble').hidden")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def command(self, name, **parameters):
        return self.driver.execute_cdp_cmd(name, parameters)

    def scheme(self, name):
        self.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, script, seconds=45):
        """Until the script returns something true, which is returned."""
        return WebDriverWait(self.driver, seconds, poll_frequency=0.1).until(lambda _: self.run(script))

    def find(self, selector):
        return self.driver.find_element("css selector", selector)

    def complaints(self):
        """What the console says of warnings and errors."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("WARNING", "SEVERE")]
