using System.Text;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;
using Engraver.Tools.Minimising;

namespace Engraver.Core.Tests.Tools;

public class DrawingMinimiserTests
{
    [Fact]
    public void Of_a_drawing_only_what_shows_the_fault_is_left()
    {
        var file = new DxfText().Header("AC1015", 4).Section("ENTITIES", [.. OddDrawings.LwPolyline, .. OddDrawings.Spline, (0, "CIRCLE"), (5, "2F"), (8, "CUT"), (62, 3), (10, 1.5), (20, 2.5), (40, -12.75), .. OddDrawings.Hatch]).End().ToAscii();

        var smallest = Minimised(file, "DXF0011");

        Assert.Equal("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n-12.75", Normal(Minimised(file, "DXF0011", keepPoint: true)));
        Assert.True(smallest.Length < 100, Encoding.Latin1.GetString(smallest));
        Assert.Contains("DXF0011", DxfReading.Ids(DxfReading.Of(smallest)));
    }

    [Fact]
    public void The_same_file_gives_the_same_result_and_a_second_round_finds_nothing_more()
    {
        var file = OddDrawings.OneOfEverything().ToAscii();
        var once = Minimised(file, "DXF0041");

        Assert.Equal(once, Minimised(file, "DXF0041"));
        Assert.Equal(once.Length, Minimised(once, "DXF0041").Length);
    }

    [Fact]
    public void A_binary_drawing_becomes_text_where_the_fault_survives_that()
    {
        var smallest = Minimised(OddDrawings.OneOfEverything().ToBinary(oneByteCodes: false), "DXF0041");

        Assert.StartsWith("0\nS", Encoding.Latin1.GetString(smallest), StringComparison.Ordinal);
        Assert.Contains("SPLINE", Encoding.Latin1.GetString(smallest), StringComparison.Ordinal);
    }

    [Fact]
    public void A_fault_that_needs_everything_keeps_everything()
    {
        var file = Encoding.ASCII.GetBytes("0\nSECTION\n2\nENTITIES\n");

        Assert.Equal(file, DrawingMinimiser.Minimise(file, candidate => candidate.AsSpan().SequenceEqual(file), CancellationToken.None));
    }

    [Fact]
    public void The_search_can_be_stopped() =>
        Assert.Throws<OperationCanceledException>(() => DrawingMinimiser.Minimise(OddDrawings.OneOfEverything().ToAscii(), _ => true, new CancellationToken(canceled: true)));

    private static byte[] Minimised(byte[] file, string id, bool keepPoint = false) => DrawingMinimiser.Minimise(
        file, candidate => DxfReading.Ids(DxfReading.Of(candidate)).Contains(id) && (!keepPoint || Encoding.Latin1.GetString(candidate).Contains("-12.75", StringComparison.Ordinal)), CancellationToken.None);

    private static string Normal(byte[] file) => Encoding.Latin1.GetString(file).Replace(" ", "", StringComparison.Ordinal).TrimEnd();
}
