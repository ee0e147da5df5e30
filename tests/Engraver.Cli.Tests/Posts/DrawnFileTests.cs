using System.Diagnostics;
using System.Text.Json;

namespace Engraver.Cli.Tests.Posts;

/// <summary>Results of the drawing commands, saved and read by ezdxf: types, values and no errors.</summary>
public class DrawnFileTests
{
    private const string Audit = """
        import sys, json, math, ezdxf
        from ezdxf import recover
        strict = ezdxf.readfile(sys.argv[1])
        document, auditor = recover.readfile(sys.argv[1])
        again = strict.audit()
        def told(e):
            d, r = e.dxf, lambda *numbers: [round(n, 6) + 0.0 for n in numbers]
            if e.dxftype() == "LINE": return r(*d.start.vec2, *d.end.vec2)
            if e.dxftype() == "CIRCLE": return r(*d.center.vec2, d.radius)
            if e.dxftype() == "ARC": return r(*d.center.vec2, d.radius, d.start_angle, d.end_angle, d.extrusion.z)
            if e.dxftype() == "ELLIPSE": return r(*d.center.vec2, *d.major_axis.vec2, d.ratio, math.degrees(d.start_param), math.degrees(d.end_param))
            return [e.closed, len(e)] + r(*(b for *_, b in e.get_points("xyb")))
        print(json.dumps({"errors": len(auditor.errors) + len(again.errors), "fixes": len(auditor.fixes) + len(again.fixes), "units": strict.header["$INSUNITS"],
                          "drawn": [[e.dxftype(), e.dxf.layer, e.dxf.color, told(e)] for e in strict.modelspace()]}))
        """;

    private const string Script = """
        NEW
        LINE 0,0 @10<45 @5,0

        CIRCLE 20,20 3
        ARC 40,0 C 30,0 30,10
        ARC -10,0 0,10 10,0
        PLINE 0,50 10,50 A 10,60 L 0,60 A CL
        RECTANG F 1 60,0 64,3
        POLYGON 6 80,0 I 5
        ELLIPSE C 100,0 110,0 5
        ELLIPSE A C 100,50 100,60 5 0 90

        """;

    [EzdxfTheory]
    [InlineData("drawn.dxf")]
    public async Task A_stranger_finds_what_was_drawn(string name)
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf(name);
        var run = await CliRun.RunAsync("script", folder.WithFile("draw.scr", $"{Script.TrimEnd()}\nSAVEAS \"{file}\"\n"));
        Assert.Equal(ExitCode.Done, run.ExitCode);
        var audit = await AuditAsync(file, folder);

        Assert.Equal((0, 0, 4), (audit.GetProperty("errors").GetInt32(), audit.GetProperty("fixes").GetInt32(), audit.GetProperty("units").GetInt32()));
        Assert.Equal(
            [
                """["LINE", "0", 256, [0.0, 0.0, 7.071068, 7.071068]]""",
                """["LINE", "0", 256, [7.071068, 7.071068, 12.071068, 7.071068]]""",
                """["CIRCLE", "0", 256, [20.0, 20.0, 3.0]]""",
                """["ARC", "0", 256, [30.0, 0.0, 10.0, 0.0, 90.0, 1.0]]""",
                """["ARC", "0", 256, [0.0, 0.0, 10.0, 0.0, 180.0, 1.0]]""",
                """["LWPOLYLINE", "0", 256, [true, 4, 0.0, 1.0, 0.0, 1.0]]""",
                """["LWPOLYLINE", "0", 256, [true, 8, 0.0, 0.414214, 0.0, 0.414214, 0.0, 0.414214, 0.0, 0.414214]]""",
                """["LWPOLYLINE", "0", 256, [true, 6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]]""",
                """["ELLIPSE", "0", 256, [100.0, 0.0, 10.0, 0.0, 0.5, 0.0, 360.0]]""",
                """["ELLIPSE", "0", 256, [100.0, 50.0, 0.0, 10.0, 0.5, 0.0, 90.0]]""",
            ],
            audit.GetProperty("drawn").EnumerateArray().Select(one => one.GetRawText()));
    }

    private static async Task<JsonElement> AuditAsync(string file, TemporaryFolder folder)
    {
        var start = new ProcessStartInfo(EzdxfTheoryAttribute.Python, [folder.WithFile("audit.py", Audit), file]) { RedirectStandardOutput = true };
        start.Environment["XDG_CACHE_HOME"] = Path.GetDirectoryName(file);
        using var process = Process.Start(start)!;
        var text = await process.StandardOutput.ReadToEndAsync();
        await process.WaitForExitAsync();
        Assert.Equal(0, process.ExitCode);
        return JsonDocument.Parse(text).RootElement;
    }
}
