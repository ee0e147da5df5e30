using Engraver.TestKit;

namespace Engraver.Cli.Tests.Browsers;

/// <summary>A test that opens a page in Debian's chromium. It runs in <c>./test --full</c>, which installs chromium, and is skipped without it. It is not part
/// of the fast subset.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BrowserTheoryAttribute : FullRunTheoryAttribute
{
    public BrowserTheoryAttribute()
    {
        if (Browser.Program is null) Skip = "chromium is not installed (apt-get install chromium).";
    }
}
