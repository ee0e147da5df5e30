using Engraver.TestKit;
using Xunit.Abstractions;
using Xunit.Sdk;

namespace Engraver.Cli.Tests.Browsers;

/// <summary>A test that opens a page in Debian's chromium. It belongs to <c>./test --full</c>, which installs it; there it is skipped where chromium is missing. In a commit's share, which does not install a browser, it is not among the tests.</summary>
[AttributeUsage(AttributeTargets.Method)]
[XunitTestCaseDiscoverer("Engraver.Cli.Tests.Browsers.BrowserTheoryDiscoverer", "Engraver.Cli.Tests")]
public sealed class BrowserTheoryAttribute : TheoryAttribute
{
    public BrowserTheoryAttribute()
    {
        if (Browser.Program is null) Skip = "chromium is not installed (apt-get install chromium).";
    }
}

/// <summary>Finds the tests of <see cref="BrowserTheoryAttribute"/> in the full run only.</summary>
public sealed class BrowserTheoryDiscoverer(IMessageSink sink) : TheoryDiscoverer(sink)
{
    public override IEnumerable<IXunitTestCase> Discover(ITestFrameworkDiscoveryOptions discoveryOptions, ITestMethod testMethod, IAttributeInfo theoryAttribute) =>
        TestExtent.IsFull ? base.Discover(discoveryOptions, testMethod, theoryAttribute) : [];
}
