using Engraver.TestKit;

namespace Engraver.Cli.Tests.Browsers;

/// <summary>A test that opens a page in Debian's chromium. It belongs to <c>./test --full</c>, which installs it; there it is skipped where chromium is
/// missing. In a commit's share, which does not install a browser, it is not among the tests.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BrowserTheoryAttribute : FullRunTheoryAttribute
{
    public BrowserTheoryAttribute()
    {
        if (Browser.Program is null) Skip = "chromium is not installed (apt-get install chromium).";
    }
}
