using System.Globalization;
using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Media.TextFormatting;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures a page of 13,000 glyphs: Avalonia's layout with the shaping in it, the shaping alone, and drawing.</summary>
internal sealed class TextBenchmark(TextWriter output)
{
    private const int Lines = 130;
    private const int LineLength = 100;
    private const double LineHeight = 15;
    private const double FontSize = 12;
    private const double Left = 4.3;
    private const int Batches = 15;
    private const int PassesOfBatch = 10;

    /// <summary>So many that the code is recompiled before it is measured.</summary>
    private const int PassesOfWarmUp = 200;

    private const string Words = "Feed 1250.75 mm/min at X 104.3352 Y -88.0051, contour 17 of 240; AutoCAD layer OUTLINE, stroke reversed, arc 90.00 degrees. ";

    private static readonly Typeface s_typeface = new(FontFamily.Default);
    public void Run()
    {
        using var picture = new RenderTargetBitmap(new PixelSize(1000, (int)(Lines * LineHeight)));
        var page = LayOut();
        var runs = page.SelectMany(layout => layout.TextLines).SelectMany(line => line.TextRuns).OfType<ShapedTextRun>().Select(run => run.GlyphRun).ToList();
        for (var i = 0; i < PassesOfWarmUp; i++)
            Release(Draw(picture, LayOut()));
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {runs.Sum(run => run.GlyphInfos.Count):N0} glyphs | CPU ms | kB allocated |"));
        output.WriteLine("|---|---:|---:|");
        Measure("lay out and shape", () => Release(LayOut()));
        Measure("shape alone", Shape);
        Measure("draw laid-out lines", () => Draw(picture, page));
        Measure("draw glyph runs", () => Draw(picture, runs));
        Measure("lay out, shape and draw", () => Release(Draw(picture, LayOut())));
        Release(page);
    }

    private static string Text(int line) => string.Concat(Words, Words).Substring(line % Words.Length, LineLength);

    private static List<TextLayout> LayOut()
    {
        var page = new List<TextLayout>(Lines);
        for (var line = 0; line < Lines; line++)
            page.Add(new TextLayout(Text(line), s_typeface, FontSize, Brushes.White));
        return page;
    }

    private static void Release(List<TextLayout> page)
    {
        foreach (var layout in page)
            layout.Dispose();
    }

    private static void Shape()
    {
        var options = new TextShaperOptions(s_typeface.GlyphTypeface, FontSize);
        for (var line = 0; line < Lines; line++)
            TextShaper.Current.ShapeText(Text(line), options).Dispose();
    }

    private static List<TextLayout> Draw(RenderTargetBitmap picture, List<TextLayout> page)
    {
        using var context = picture.CreateDrawingContext();
        for (var line = 0; line < page.Count; line++)
            page[line].Draw(context, new Point(Left, line * LineHeight));
        return page;
    }

    private static void Draw(RenderTargetBitmap picture, List<GlyphRun> runs)
    {
        using var context = picture.CreateDrawingContext();
        for (var line = 0; line < runs.Count; line++)
        {
            using var place = context.PushTransform(Matrix.CreateTranslation(Left, line * LineHeight));
            context.DrawGlyphRun(Brushes.White, runs[line]);
        }
    }

    /// <summary>Writes the median of several batches, in processor time of the process.</summary>
    private void Measure(string what, Action pass)
    {
        for (var i = 0; i < PassesOfBatch; i++)
            pass();
        var times = new double[Batches];
        var allocated = GC.GetAllocatedBytesForCurrentThread();
        for (var batch = 0; batch < Batches; batch++)
        {
            var cpu = Environment.CpuUsage.TotalTime;
            for (var i = 0; i < PassesOfBatch; i++)
                pass();
            times[batch] = (Environment.CpuUsage.TotalTime - cpu).TotalMilliseconds / PassesOfBatch;
        }

        var kilobytes = (GC.GetAllocatedBytesForCurrentThread() - allocated) / 1e3 / Batches / PassesOfBatch;
        Array.Sort(times);
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {what} | {times[Batches / 2]:0.00} | {kilobytes:0.0} |"));
    }
}
