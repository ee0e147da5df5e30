using System.Diagnostics;
using System.Globalization;
using Engraver.Cli.Tests.Posts;

namespace Engraver.Cli.Tests.Options;

/// <summary>--units, --scale, --mirror, --rotate and --move at the drawing verbs.</summary>
public sealed class PlacementOptionTests : IDisposable
{
    /// <summary>A drawing of every type of entity, and the same transformed by ezdxf in the order of the options.</summary>
    private const string Witness = """
        import sys, math, ezdxf
        from ezdxf.math import Matrix44
        doc = ezdxf.new("R2010", units=4); m = doc.modelspace()
        m.add_line((1, 2, 3), (4, -5, 6)); m.add_circle((3, 1, 2), 2); m.add_arc((5, 5, -1), 3, 20, 110)
        m.add_arc((5, 5, 1), 3, 20, 110, dxfattribs={"extrusion": (0, 0, -1)})
        m.add_lwpolyline([(0, 0, 0.5), (4, 0, 0), (4, 4, -0.3), (0, 4, 1)], format="xyb", close=True, dxfattribs={"elevation": 2})
        m.add_ellipse((2, 3, 1), (4, 1, 0), 0.4, 0.3, 4)
        s = m.add_spline(); s.control_points = [(0, 0, 0), (1, 3, 1), (4, 3, 2), (5, 0, 0), (7, 1, 0)]; s.dxf.degree = 3; s.knots = [0, 0, 0, 0, .5, 1, 1, 1, 1]
        b = doc.blocks.new("B"); b.add_arc((1, 0), 2, 0, 70); b.add_line((0, 0), (2, 1))
        m.add_blockref("B", (6, 2, 1), dxfattribs={"xscale": -1.5, "yscale": 1.5, "zscale": 1.5, "rotation": 25})
        m.add_polyline2d([(8, 0), (9, 2), (10, 0)], format="xy"); m.add_polyline3d([(0, 8, 1), (2, 9, 3), (4, 8, 0)])
        m.add_text("Ab7", height=2, rotation=15).set_placement((2, 10))
        doc.saveas(sys.argv[1])
        for axis, x, y in (("x", 1, -1), ("y", -1, 1)):
            again = ezdxf.readfile(sys.argv[1])
            for e in list(again.modelspace()): e.transform(Matrix44.scale(2.5) @ Matrix44.scale(x, y, 1) @ Matrix44.z_rotate(math.radians(35)) @ Matrix44.translate(11, -7, 0))
            again.saveas(sys.argv[1] + axis + ".dxf")
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [EzdxfTheory]
    [InlineData("source.dxf")]
    public async Task The_table_is_that_of_a_drawing_that_ezdxf_has_transformed(string name)
    {
        var file = _folder.PathOf(name);
        var start = new ProcessStartInfo(EzdxfTheoryAttribute.Python, [_folder.WithFile("witness.py", Witness), file]);
        start.Environment["XDG_CACHE_HOME"] = Path.GetDirectoryName(file);
        using (var process = Process.Start(start)!) await process.WaitForExitAsync();
        foreach (var axis in (string[])["x", "y"])
        {
            var placed = await TableAsync(file, "--move", "11,-7", "--rotate", "35", "--mirror", axis, "--scale", "5:2");
            var witness = await TableAsync($"{file}{axis}.dxf");

            Assert.True(placed.Count > 25);
            Assert.Equal(witness, placed, (one, other) => one.Zip(other).All(pair => Math.Abs(pair.First - pair.Second) < 1e-9));
        }
    }

    [Theory]
    [InlineData("mm", 10.0)]
    [InlineData("cm", 100.0)]
    [InlineData("m", 10000.0)]
    [InlineData("inch", 254.0)]
    [InlineData("ft", 3048.0)]
    public async Task Each_unit_has_its_length(string unit, double end)
    {
        var table = await TableAsync(Line(), "--units", unit);
        Assert.Equal(end, table[0][4], 9);
    }

    [Fact]
    public async Task A_displacement_is_in_millimetres_in_every_unit()
    {
        var table = await TableAsync(Line(), "--units", "cm", "--scale", "1:2", "--move", "3,4");
        Assert.Equal([1.0, 3.0, 4.0, 0.0, 53.0, 4.0, 0.0], table[0].Take(7));
    }

    [Theory]
    [InlineData("--scale", "0", "--scale: '0' is not a number above 0")]
    [InlineData("--scale", "1:0", "--scale: 1:0 is not a ratio of two numbers above 0.")]
    [InlineData("--rotate", "3601", "--rotate: 3601 is not an angle from -3600 to 3600 degrees.")]
    [InlineData("--move", "3", "--move: '3' is not a point.")]
    [InlineData("--mirror", "z", "'z'")]
    [InlineData("--units", "km", "'km'")]
    public async Task A_wrong_value_is_refused(string option, string value, string message)
    {
        var run = await CliRun.RunAsync("info", Line(), option, value);
        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    /// <summary>The placement is in the record: a program of the placed drawing is not one of the drawing in its file.</summary>
    [Fact]
    public async Task A_program_is_verified_with_its_placement()
    {
        var program = _folder.PathOf("line.dmc");
        string[] placement = ["--scale", "2", "--mirror", "x", "--rotate", "30", "--move", "5,5"];
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["post", Line(), "--target", "galil", "-o", program, .. placement])).ExitCode);

        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["verify", program, "--against", Line(), .. placement])).ExitCode);
        Assert.NotEqual(ExitCode.Done, (await CliRun.RunAsync(["verify", program, "--against", Line(), "--scale", "2"])).ExitCode);
        Assert.Contains("placed: scaled by 2, mirrored about the X axis, rotated by 30 degrees, moved by 5,5 mm", (await CliRun.RunAsync(["info", Line(), .. placement])).Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["info", Line(), "--twice", .. placement])).ExitCode);
    }

    private string Line() => _folder.WithFile("line.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n10\n21\n0\n0\nENDSEC\n0\nEOF\n");

    private static async Task<IReadOnlyList<double[]>> TableAsync(string file, params string[] options)
    {
        var run = await CliRun.RunAsync(["table", file, "--as-drawn", "--format", "csv", "--cut", "text", .. options]);
        return [.. run.Out.Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(row => row.Split(',').Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray())];
    }
}
