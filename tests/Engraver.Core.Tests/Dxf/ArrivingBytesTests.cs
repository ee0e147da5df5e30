using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>A drawing that is parsed while its file is read is the same as one that is parsed afterwards.</summary>
public class ArrivingBytesTests
{
    private static readonly DxfText s_lines = new DxfText().Header("AC1015", 4).Section("TABLES").Section("BLOCKS").Section("ENTITIES", [.. Enumerable.Range(0, 600).SelectMany(Line)]).End();

    /// <summary>Line ends, comments longer than one block of the file, text that is not a pair, the entities before their blocks, an end inside a pair, zeros,
    /// a byte order mark, the binary form.</summary>
    public static TheoryData<string> Forms => ["LF", "CRLF", "CR", "comment", "damage", "blocks last", "cut", "zeros", "mark", "wide", "binary", "short", "empty"];

    [Theory]
    [MemberData(nameof(Forms))]
    public void It_is_the_same_drawing(string form)
    {
        var file = FileOf(form);
        var whole = DxfReading.Of(file);
        foreach (var more in new[] { 0, 1, 7, 4096, 1 << 20 })
        {
            var arriving = new SlowFileBytes(file, () => more);
            var drawing = DxfReader.Read(arriving, "test.dxf", DxfReadOptions.Default, CancellationToken.None);

            Assert.Equal(DxfReading.Fingerprint(whole), DxfReading.Fingerprint(drawing));
            Assert.Equal(whole.Diagnostics.Select(found => found.Message), drawing.Diagnostics.Select(found => found.Message));
            Assert.Equal(whole.Bytes, drawing.Bytes);
        }
    }

    [Fact]
    public void A_usual_file_is_never_waited_for_as_a_whole()
    {
        var file = FileOf("LF");
        var arriving = new SlowFileBytes(file, () => 0);
        DxfReader.Read(arriving, "test.dxf", DxfReadOptions.Default, CancellationToken.None);

        Assert.InRange(arriving.LongestWait, 1, 4096);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(64)]
    [InlineData(10_000)]
    public void What_cannot_be_read_to_its_end_is_no_drawing(int readable)
    {
        var arriving = new SlowFileBytes(FileOf("LF"), () => 100) { Readable = readable };
        Assert.Equal("the disk is broken", Assert.Throws<IOException>(() => DxfReader.Read(arriving, "test.dxf", DxfReadOptions.Default, CancellationToken.None)).Message);
    }

    private static byte[] FileOf(string form) => form switch
    {
        "CRLF" => s_lines.ToAscii("\r\n"),
        "CR" => s_lines.ToAscii("\r"),
        "comment" => With((999, new string('x', 50_000))),
        "damage" => With((0, "LINE\nthis is no code\nand this is not one")),
        "blocks last" => new DxfText().Header("AC1015", 4).Section("ENTITIES", [.. Enumerable.Range(0, 600).SelectMany(Line), (0, "INSERT"), (2, "B"), (10, 1.0), (20, 2.0)])
            .Section("BLOCKS", (0, "BLOCK"), (2, "B"), (10, 0.0), (20, 0.0), (0, "CIRCLE"), (8, "0"), (10, 0.0), (20, 0.0), (40, 1.0), (0, "ENDBLK")).End().ToAscii(),
        "cut" => s_lines.ToAscii()[..^40],
        "zeros" => [.. s_lines.ToAscii().Select((value, at) => at is > 20_000 and < 20_512 ? (byte)0 : value)],
        "mark" => [.. "\uFEFF"u8, .. s_lines.ToAscii()],
        "wide" => System.Text.Encoding.Unicode.GetBytes(System.Text.Encoding.UTF8.GetString(s_lines.ToAscii())),
        "binary" => s_lines.ToBinary(oneByteCodes: false),
        "short" => "  0\nEOF\n"u8.ToArray(),
        "empty" => [],
        _ => s_lines.ToAscii(),
    };

    /// <summary>The lines, with something unusual in the middle.</summary>
    private static byte[] With((int Code, object Value) unusual) =>
        new DxfText().Header("AC1015", 4).Section("TABLES").Section("BLOCKS").Section("ENTITIES", [.. Enumerable.Range(0, 300).SelectMany(Line), unusual, .. Enumerable.Range(300, 300).SelectMany(Line)]).End().ToAscii();

    private static (int Code, object Value)[] Line(int number) =>
        [(0, "LINE"), (5, (number + 256).ToString("X", System.Globalization.CultureInfo.InvariantCulture)), (8, "0"), (10, number * 0.37), (20, 0.1), (11, number * 0.37), (21, 1.25)];
}
