using System.Diagnostics;
using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Site;

/// <summary>The site in Debian's chromium, which only the full run installs; a commit checks the files of the site.</summary>
public partial class SiteInBrowserTests(SiteFixture site) : IClassFixture<SiteFixture>
{
    /// <summary>Types a word into the search, then reports the results, the width of the page and the scripts that ran.</summary>
    private const string Probe = """
        <script>addEventListener('load', async () => {
            const input = document.querySelector('.search input');
            input.value = 'controller'; input.dispatchEvent(new Event('input'));
            for (let i = 0; i < 100 && !document.querySelector('.results a'); i++) await new Promise(done => setTimeout(done, 20));
            const found = document.querySelectorAll('.results a').length;
            document.querySelector('.results').hidden = true;
            const wide = document.documentElement, report = document.createElement('pre');
            report.textContent = `found=${found} copy=${document.querySelectorAll('.code button').length} over=${wide.scrollWidth - wide.clientWidth} at=${wide.clientWidth}.`;
            document.body.append(report);
        });</script>
        """;

    /// <summary>Pages with tables, code, pictures and long words.</summary>
    public static TheoryData<string, int> Cases
    {
        get
        {
            var cases = new TheoryData<string, int>();
            foreach (var address in (string[])["index.html", "docs/index.html", "docs/library.html", "docs/settings.html", "docs/operating.html", "docs/reference/galil-dmc.html"])
            {
                foreach (var width in (int[])[500, 1400]) cases.Add(address, width);
            }

            return cases;
        }
    }

    [SiteBrowserTheory]
    [MemberData(nameof(Cases))]
    public async Task A_page_fits_its_window_and_its_search_works_from_a_file(string address, int width)
    {
        var page = Path.Combine(site.Folder, address);
        var copy = Path.ChangeExtension(page, string.Create(CultureInfo.InvariantCulture, $".{width}.html"));
        File.WriteAllText(copy, File.ReadAllText(page).Replace("</body>", Probe + "</body>", StringComparison.Ordinal));
        var shown = Report().Match(await ShowAsync(copy, width));
        File.Delete(copy);

        Assert.True(shown.Success);
        Assert.InRange(Number(shown, "found"), 1, 20);
        Assert.Equal(0, Number(shown, "over"));
        Assert.InRange(Number(shown, "at"), width - 20, width);
        if (address == "docs/library.html") Assert.True(Number(shown, "copy") > 2);
    }

    private static int Number(Match report, string name) => int.Parse(report.Groups[name].Value, CultureInfo.InvariantCulture);

    private async Task<string> ShowAsync(string page, int width)
    {
        string[] words = ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", $"--user-data-dir={site.Folder}-browser", string.Create(CultureInfo.InvariantCulture, $"--window-size={width},900"), "--virtual-time-budget=5000", "--dump-dom", new Uri(page).AbsoluteUri];
        using var process = Process.Start(new ProcessStartInfo("chromium", words) { RedirectStandardOutput = true, RedirectStandardError = true })!;
        var (shown, said) = (process.StandardOutput.ReadToEndAsync(), process.StandardError.ReadToEndAsync());
        await process.WaitForExitAsync();
        Assert.True(process.ExitCode == 0, await said);
        return await shown;
    }

    [GeneratedRegex(@"found=(?<found>\d+) copy=(?<copy>\d+) over=(?<over>-?\d+) at=(?<at>\d+)\.</pre>")]
    private static partial Regex Report();
}

/// <summary>A test of the full run that is skipped if chromium is not installed.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class SiteBrowserTheoryAttribute : FullRunTheoryAttribute
{
    public SiteBrowserTheoryAttribute()
    {
        var places = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Where(place => place.Length > 0);
        if (!places.Any(place => File.Exists(Path.Combine(place, "chromium")))) Skip = "chromium is not installed (apt-get install chromium).";
    }
}
