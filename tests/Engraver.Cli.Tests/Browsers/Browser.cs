using System.Diagnostics;
using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Engraver.Cli.Tests.Browsers;

/// <summary>Headless Chromium: prints a page, takes screenshots and measures its layout.</summary>
internal sealed partial class Browser(TemporaryFolder folder)
{
    /// <summary>Millimetres to the pixels of CSS.</summary>
    private const double PixelsPerMillimetre = 96.0 / 25.4;

    /// <summary>Checks every element for content beyond the sheet or its own frame, and the content of each picture.</summary>
    private const string Measure = """
        const sheet = document.documentElement.clientWidth, name = e => e.tagName + '.' + (e.getAttribute('class') || '') + ' ' + (e.closest('section') || document.body).id + ' ' + e.textContent.trim().slice(0, 40);
        const beyond = [], pictures = [];
        for (const e of document.querySelectorAll('body *')) {
            if (e.closest('svg') || e.tagName === 'SCRIPT') continue;
            const r = e.getBoundingClientRect();
            if (r.right > sheet + 0.5 || r.left < -0.5 || (e.clientWidth > 0 && e.scrollWidth > e.clientWidth + 1)) beyond.push(name(e));
        }
        for (const svg of document.querySelectorAll('figure svg')) {
            const s = svg.getBoundingClientRect();
            let left = 1e9, top = 1e9, right = -1e9, bottom = -1e9, ink = 0;
            for (const p of svg.querySelectorAll('path.cut, path.cutting')) {
                const r = p.getBoundingClientRect(), look = getComputedStyle(p);
                if (look.stroke === 'none' || look.stroke === 'rgb(255, 255, 255)' || svg.querySelector('.caption') && r.top > svg.querySelector('.caption').getBoundingClientRect().top - 1) continue;
                ink++; left = Math.min(left, r.left); right = Math.max(right, r.right); top = Math.min(top, r.top); bottom = Math.max(bottom, r.bottom);
            }
            for (const t of svg.querySelectorAll('text')) {
                const r = t.getBoundingClientRect();
                if (r.left < s.left - 0.5 || r.right > s.right + 0.5 || r.top < s.top - 0.5 || r.bottom > s.bottom + 0.5) beyond.push(name(t));
            }
            pictures.push({ section: svg.closest('section').id, width: s.width, height: s.height, ink, inkedWidth: right - left, inkedHeight: bottom - top });
        }
        const broken = [];
        for (const cell of document.querySelectorAll('th, td:not(:last-child)')) {
            for (const text of cell.childNodes) {
                if (text.nodeType !== Node.TEXT_NODE) continue;
                for (const word of text.data.matchAll(/[\p{L}\p{N}]{1,20}/gu)) {
                    const range = document.createRange(); range.setStart(text, word.index); range.setEnd(text, word.index + word[0].length);
                    if (new Set([...range.getClientRects()].map(r => Math.round(r.top))).size > 1) broken.push(word[0] + ' in ' + name(cell));
                }
            }
        }
        const found = document.createElement('pre'); found.id = 'found';
        found.textContent = btoa(unescape(encodeURIComponent(JSON.stringify({ beyond, broken, pictures })))); document.body.append(found);
        """;

    /// <summary>Path of the program; null if it is not installed.</summary>
    public static string? Program { get; } = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Where(place => place.Length > 0).Select(place => Path.Combine(place, "chromium")).FirstOrDefault(File.Exists);

    /// <summary>The printed sheets of a page with their sizes in points.</summary>
    public async Task<IReadOnlyList<(double Width, double Height)>> PrintAsync(string page, string pdf)
    {
        await RunAsync($"--print-to-pdf={pdf}", "--no-pdf-header-footer", Url(page));
        var text = Encoding.Latin1.GetString(await File.ReadAllBytesAsync(pdf));
        return [.. Sheet().Matches(text).Select(sheet => (Number(sheet.Groups[1].Value), Number(sheet.Groups[2].Value)))];
    }

    /// <summary>A screenshot of the page in a window of this size.</summary>
    public Task PhotographAsync(string page, string png, int width, int height) => RunAsync($"--screenshot={png}", Window(width, height), Url(page));

    /// <summary>Layout of the page in a window, or on A4 with margins of 14 mm.</summary>
    /// <param name="width">Pixels; null: on paper.</param>
    public async Task<PageLayout> LayOutAsync(string page, int? width)
    {
        var text = Policy().Replace(await File.ReadAllTextAsync(page), "");
        if (width is null) text = text.Replace("@media print", "@media all", StringComparison.Ordinal);
        var copy = folder.WithFile($"layout-{width}.html", text.Replace("</body>", $"<script>{Measure}</script></body>", StringComparison.Ordinal));
        var shown = await RunAsync("--dump-dom", Window(width ?? (int)(182.0 * PixelsPerMillimetre), 1000), Url(copy));
        var found = Found().Match(shown);
        Assert.True(found.Success, "The page was not measured.");
        return JsonSerializer.Deserialize<PageLayout>(Convert.FromBase64String(found.Groups[1].Value), JsonSerializerOptions.Web)!;
    }

    private async Task<string> RunAsync(params string[] words)
    {
        using var process = Process.Start(new ProcessStartInfo(Program!, ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", $"--user-data-dir={folder.PathOf("browser")}", .. words]) { RedirectStandardOutput = true, RedirectStandardError = true })!;
        var (shown, said) = (process.StandardOutput.ReadToEndAsync(), process.StandardError.ReadToEndAsync());
        await process.WaitForExitAsync();
        Assert.True(process.ExitCode == 0, await said);
        return await shown;
    }

    private static string Window(int width, int height) => string.Create(CultureInfo.InvariantCulture, $"--window-size={width},{height}");

    private static string Url(string path) => new Uri(path).AbsoluteUri;

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    [GeneratedRegex(@"/MediaBox\s*\[\s*0\s+0\s+([0-9.]+)\s+([0-9.]+)\s*\]")]
    private static partial Regex Sheet();

    [GeneratedRegex("<meta http-equiv=\"Content-Security-Policy\"[^>]*>")]
    private static partial Regex Policy();

    [GeneratedRegex("id=\"found\">([^<]*)<")]
    private static partial Regex Found();
}

/// <summary>Layout of a page.</summary>
/// <param name="Beyond">Elements that reach beyond the sheet, their frame or their picture.</param>
/// <param name="Broken">Words broken across lines, in every column except the last, which contains long text.</param>
internal sealed record PageLayout(IReadOnlyList<string> Beyond, IReadOnlyList<string> Broken, IReadOnlyList<PagePicture> Pictures);

/// <summary>A picture of a page, in pixels.</summary>
/// <param name="Section">Its key.</param>
/// <param name="Ink">Number of visible curves.</param>
/// <param name="InkedWidth">Width of their bounding box.</param>
/// <param name="InkedHeight">Height of their bounding box.</param>
internal sealed record PagePicture(string Section, double Width, double Height, int Ink, double InkedWidth, double InkedHeight);
