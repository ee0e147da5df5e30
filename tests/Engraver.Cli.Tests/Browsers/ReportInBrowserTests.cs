using Engraver.TestKit;

namespace Engraver.Cli.Tests.Browsers;

/// <summary>The job report as shown and printed by a browser. Pictures and sheets are stored in artifacts/report for review.</summary>
public class ReportInBrowserTests
{
    private const double A4Width = 595.0;
    private const double A4Height = 842.0;

    [BrowserTheory]
    [InlineData("gasket", "en", true)]
    [InlineData("nameplate", "de", true)]
    [InlineData("many", "en", false)]
    public async Task A_report_stays_on_its_sheets_and_its_pictures_are_not_empty(string name, string culture, bool isRun)
    {
        using var folder = new TemporaryFolder();
        var (browser, kept) = (new Browser(folder), Directory.CreateDirectory(Path.Combine(RepositoryFolder.Root, "artifacts", "report")).FullName);
        var (drawing, page) = (await DrawingAsync(folder, name), Path.Combine(kept, name + ".html"));
        if (isRun) Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("certify", drawing)).ExitCode);
        if (isRun) Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--journal", folder.PathOf("a.jsonl"))).ExitCode);
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync("report", drawing, "--rate", "60,2.5,0.75", "--culture", culture, "-o", page)).ExitCode);

        Assert.InRange(new FileInfo(page).Length, 10_000, 5_000_000);
        var sheets = await browser.PrintAsync(page, Path.Combine(kept, name + ".pdf"));
        Assert.InRange(sheets.Count, 2, isRun ? 6 : 12); // Many lines give many findings: at most 500 are listed.
        Assert.All(sheets, sheet => Assert.Equal((A4Width, A4Height), (Math.Round(sheet.Width), Math.Round(sheet.Height))));
        foreach (int? width in new int?[] { 1280, 600, null })
        {
            var layout = await browser.LayOutAsync(page, width);
            Assert.True(layout.Beyond.Count == 0, $"{(width is { } pixels ? FormattableString.Invariant($"{pixels} pixels") : "paper")}: {string.Join("; ", layout.Beyond)}");
            Assert.True(layout.Broken.Count == 0, $"{width}: {string.Join("; ", layout.Broken.Take(5))}");
            Assert.Equal(isRun ? ["path", "speed", "deviation"] : ["path", "speed"], layout.Pictures.Select(picture => picture.Section));
            Assert.All(layout.Pictures, picture => Assert.True(picture.Ink > 0 && picture.InkedWidth > 0.3 * picture.Width && picture.InkedHeight > 0.1 * picture.Height, picture.ToString()));
        }

        await browser.PhotographAsync(page, Path.Combine(kept, name + ".png"), 1000, 3200);
        Assert.InRange(new FileInfo(Path.Combine(kept, name + ".png")).Length, 20_000, 5_000_000);
    }

    private static async Task<string> DrawingAsync(TemporaryFolder folder, string name)
    {
        if (name != "many") return folder.WithFile(name + ".dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf(name)));
        var random = new Random(7);
        var lines = Enumerable.Range(0, 120_000).SelectMany(i => (IEnumerable<(int, object)>)[(0, "LINE"), (10, 1.0 * (i % 400)), (20, 1.0 * (i / 400)), (11, (i % 400) + (0.9 * random.NextDouble())), (21, (i / 400) + (0.9 * random.NextDouble()))]);
        await File.WriteAllBytesAsync(folder.PathOf("many.dxf"), DxfText.WithEntities([.. lines]).ToAscii());
        return folder.PathOf("many.dxf");
    }
}
