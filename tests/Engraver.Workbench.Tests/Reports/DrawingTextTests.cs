using System.Text;
using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Reports;

public sealed class DrawingTextTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-text-");

    [Theory]
    [InlineData("", ": nothing could be read\n")]
    [InlineData("AC1032\0\0\0\0\0\0", ": 12 bytes, nothing could be read\n")]
    [InlineData("\u007fELF\u0001\u0002\u0003", ": 7 bytes, nothing could be read\n")]
    [InlineData("hello\nworld\n", ": 12 bytes, nothing could be read\n")]
    public void Of_a_file_that_is_no_drawing_only_what_is_known_is_said(string content, string said) => Assert.EndsWith(said, TextOf(content), StringComparison.Ordinal);

    [Fact]
    public void Of_a_file_that_is_not_there_not_even_its_size_is_said()
    {
        using var text = new StringWriter { NewLine = "\n" };
        var missing = DrawingFile.Open(Path.Combine(_folder.FullName, "nowhere.dxf"), new DrawingSettings(), CancellationToken.None);
        DrawingText.Write(text, missing, DrawingSummary.From(missing));

        Assert.EndsWith("nowhere.dxf: nothing could be read\n", text.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Of_an_empty_drawing_nothing_is_counted_in_empty_brackets()
    {
        var text = TextOf("  0\nSECTION\n  2\nENTITIES\n  0\nENDSEC\n  0\nEOF\n");

        Assert.Contains("\n0 entities read = 0 cut + 0 construction + 0 refused\n", text, StringComparison.Ordinal);
        Assert.DoesNotContain("()", text, StringComparison.Ordinal);
    }

    [Fact]
    public void One_line_is_one_entity()
    {
        var text = TextOf("  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n  8\n0\n 10\n0\n 20\n0\n 11\n3\n 21\n4\n  0\nENDSEC\n  0\nEOF\n");

        Assert.Contains("\n1 entity read = 1 cut + 0 construction + 0 refused (1 LINE)\n", text, StringComparison.Ordinal);
        Assert.Contains("layer 0: 1 entity\n", text, StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private string TextOf(string content)
    {
        var path = Path.Combine(_folder.FullName, "drawing.dxf");
        File.WriteAllBytes(path, Encoding.Latin1.GetBytes(content));
        using var text = new StringWriter { NewLine = "\n" };
        var drawing = DrawingFile.Open(path, new DrawingSettings(), CancellationToken.None);
        DrawingText.Write(text, drawing, DrawingSummary.From(drawing));
        return text.ToString();
    }
}
