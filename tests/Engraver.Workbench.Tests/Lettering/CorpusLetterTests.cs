using System.Diagnostics;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Lettering;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Machines;
using Xunit.Abstractions;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>Every text of the corpus is lettered: each of its glyphs gives curves, outlines are closed, and the second calculation agrees.</summary>
public class CorpusLetterTests(ITestOutputHelper output)
{
    private static readonly DrawingSettings s_settings = new() { Cut = CutChoice.Text };

    [CorpusFact]
    public void Every_text_of_the_corpus_becomes_curves_at_its_place()
    {
        var (drawings, texts, lettered, glyphs, parts, lost) = (0, 0, 0, 0, 0, new List<string>());
        var watch = new Stopwatch();
        foreach (var file in Drawings(TestExtent.IsFull ? 1 : 6))
        {
            var drawing = DrawingFile.Open(file, s_settings, CancellationToken.None);
            if (drawing.Texts.Count == 0) continue;
            watch.Start();
            var letters = LetteredDrawing.Of(drawing, text => true, LetterLibrary.FontsOf(drawing), drawing.Scale.ToDrawing(s_settings.MaxErrorMm), CancellationToken.None);
            watch.Stop();
            Assert.True(letters.Faults.Count == 0, $"{file}: {string.Join(' ', letters.Faults.Select(fault => fault.Sentence))}");
            Assert.Equal(drawing.Texts.Count, letters.Texts.Count + letters.Drawing.Texts.Count);
            Assert.Equal(letters.Drawing.Texts.Count, letters.Findings.Count(finding => finding.Id is "TXT0010" or "TXT0011" or "TXT0015"));
            Assert.All(letters.Texts, text => AssertCurves(letters.Drawing, text, file));
            (drawings, texts, lettered) = (drawings + 1, texts + drawing.Texts.Count, lettered + letters.Texts.Count);
            glyphs += letters.Texts.Sum(text => text.Layout.Glyphs.Count);
            parts += letters.Texts.Sum(text => letters.Drawing.Entities[text.Entity].PartCount);
            lost.AddRange(letters.Findings.Where(finding => finding.Severity == Severity.Error).Select(finding => $"{Path.GetFileName(file)}: {finding.Sentence}"));
        }

        output.WriteLine($"{drawings} drawings, {texts} texts, {lettered} lettered, {glyphs} glyphs, {parts} curves, {watch.Elapsed.TotalSeconds:0.0} s");
        foreach (var line in lost) output.WriteLine(line);
        Assert.True(lettered > 0 && glyphs > lettered, $"{lettered} texts, {glyphs} glyphs");
    }

    /// <summary>Nothing between a lettered drawing and its motion is refused because of texts.</summary>
    [CorpusFact]
    public void Every_drawing_of_the_corpus_with_texts_is_planned()
    {
        var planned = 0;
        foreach (var file in Drawings(TestExtent.IsFull ? 1 : 12))
        {
            var drawing = DrawingFile.Open(file, s_settings, CancellationToken.None);
            if (drawing.Texts.Count == 0) continue;
            var job = JobPreparation.Prepare(drawing, s_settings, MotionStyle.Continuous);
            Assert.True(job.Faults.Count == 0, $"{file}: {string.Join(' ', job.Faults.Select(fault => fault.Sentence))}");
            var isOfLetter = job.Sequence.Discontinuities.Select(end => job.Drawing.Entities[end.EntityIndex].Type.IsLetters()).ToList();
            Assert.All(isOfLetter.Chunk(2), ends => Assert.False(ends[0] && ends[1], file)); // a stroke of a letter has no gap
            planned++;
        }

        output.WriteLine($"{planned} drawings planned");
        Assert.True(planned > 0);
    }

    private static void AssertCurves(Drawing drawing, LetteredText text, string file)
    {
        var entity = drawing.Entities[text.Entity];
        Assert.True(entity.PartCount > 0 || text.Layout.Glyphs.Count + text.Layout.Rules.Count == 0, $"{file}: {entity.Handle:X}");
        foreach (var glyph in text.Layout.Glyphs)
        {
            Assert.Contains(glyph.Curves.Contours, contour => contour.Pieces.Count > 0);
            if (glyph.Font.Font.IsOutline) Assert.All(glyph.Curves.Contours, contour => Assert.True(contour.IsClosed && contour.Pieces[^1].End == contour.Start, $"{file}: {glyph.CodePoint:X} of {glyph.Font.Font.Name}"));
        }
    }

    private static IEnumerable<string> Drawings(int every) => Directory.EnumerateFiles(RepositoryFolder.Corpus!, "*.dxf", SearchOption.AllDirectories)
        .Where(file => new FileInfo(file).Length < 8_000_000).Order(StringComparer.Ordinal).Where((_, number) => number % every == 0);
}
