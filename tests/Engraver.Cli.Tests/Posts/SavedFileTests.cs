using System.Diagnostics;
using System.Text.Json;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Posts;

/// <summary>Files written by SAVEAS and as CL data, read by ezdxf.</summary>
public class SavedFileTests
{
    private const string Audit = """
        import sys, json, ezdxf
        from ezdxf import recover
        strict = ezdxf.readfile(sys.argv[1])
        document, auditor = recover.readfile(sys.argv[1])
        again = strict.audit()
        space = strict.modelspace()
        print(json.dumps({"errors": len(auditor.errors) + len(again.errors), "fixes": len(auditor.fixes) + len(again.fixes), "types": sorted(e.dxftype() for e in space if e.dxf.layer != "RAPID"),
                          "layers": [[l.dxf.name, l.color, l.is_on(), l.is_frozen(), bool(l.dxf.plot)] for l in strict.layers if l.dxf.name != "Defpoints"], "units": strict.header["$INSUNITS"]}))
        """;

    private static readonly (int, object)[] s_layers =
        [(0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "Контур 輪郭"), (62, -5), (70, 0), (0, "LAYER"), (2, "TRUE"), (62, 3), (420, 0x123456), (70, 1), (290, 0), (0, "ENDTAB")];

    private static readonly (int, object)[] s_curves =
    [
        (0, "ELLIPSE"), (8, "0"), (10, 0.0), (20, 0.0), (11, 5.0), (21, 0.0), (40, 0.5), (41, 0.0), (42, 3.0),
        (0, "SPLINE"), (8, "0"), (70, 8), (71, 3), (72, 8), (73, 4), (40, 0.0), (40, 0.0), (40, 0.0), (40, 0.0), (40, 1.0), (40, 1.0), (40, 1.0), (40, 1.0), (10, 20.0), (20, 0.0), (10, 21.0), (20, 2.0), (10, 23.0), (20, 2.0), (10, 24.0), (20, 0.0),
        (0, "LWPOLYLINE"), (8, "0"), (62, 1), (90, 3), (70, 1), (10, 40.0), (20, 0.0), (42, 1.0), (10, 45.0), (20, 0.0), (10, 42.0), (20, 5.0),
        (0, "LINE"), (8, "TRUE"), (420, 0xFF8000), (10, 0.0), (20, 9.0), (11, 3.0), (21, 9.0),
    ];

    private static readonly (int, object)[] s_yard =
    [
        (0, "LINE"), (8, "0"), (10, 0.0), (20, 0.0), (11, 100.0), (21, 0.0), (0, "LINE"), (8, "0"), (10, 0.0), (20, 100.0), (11, 0.0), (21, 0.0),
        (0, "LINE"), (8, "0"), (10, 30.0), (20, -9.0), (11, 30.0), (21, 80.0), (0, "LINE"), (8, "0"), (10, 50.0), (20, -9.0), (11, 50.0), (21, 80.0),
        (0, "CIRCLE"), (8, "0"), (10, 50.0), (20, 50.0), (40, 10.0), (0, "ELLIPSE"), (8, "0"), (10, 200.0), (20, 50.0), (11, 10.0), (21, 0.0), (40, 0.5), (41, 0.0), (42, 2.0 * Math.PI),
        (0, "LWPOLYLINE"), (8, "0"), (90, 4), (70, 1), (10, 300.0), (20, 0.0), (10, 310.0), (20, 0.0), (42, 0.5), (10, 310.0), (20, 10.0), (10, 300.0), (20, 10.0),
    ];

    [EzdxfTheory]
    [InlineData(1)]
    [InlineData(4)]
    public async Task A_stranger_finds_the_saved_curves_layers_and_units(int units)
    {
        using var folder = new TemporaryFolder();
        var audit = await AuditAsync(await SavedAsync(folder, units), folder);

        Assert.Equal((0, 0), (audit.GetProperty("errors").GetInt32(), audit.GetProperty("fixes").GetInt32()));
        Assert.Equal("""["ELLIPSE", "LINE", "LWPOLYLINE", "SPLINE"]""", audit.GetProperty("types").GetRawText());
        Assert.Equal(units, audit.GetProperty("units").GetInt32());
        var layers = audit.GetProperty("layers").EnumerateArray().ToDictionary(layer => layer[0].GetString()!, layer => string.Join(' ', layer.EnumerateArray().Skip(1).Select(value => value.GetRawText())));
        Assert.Contains("5 false false true", layers.Values);
        Assert.Equal("7 true true false", layers["TRUE"]);
    }

    /// <summary>Four lines about a circle, an ellipse and a bulged polyline; each reshaping command is applied to them, and ezdxf finds the expected
    /// result.</summary>
    [EzdxfTheory]
    [InlineData("TRIM  40,0 ", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("TRIM  60,50 ", "ARC,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("TRIM  60,50 shift:48,59 ", "ARC,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("FILLET R 3 10,0 0,10", "ARC,CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("CHAMFER D 3 4 10,0 0,10", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("BREAK 60,50 F 60,50 50,60", "ARC,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("BREAK 210,50 F 210,50 200,45", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("FILLET R 2 P 305,0", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("FILLET R 2 P 305,0 CHPROP 303,0  Closed No", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("PLINE 400,0 420,0 420,20  CHPROP L  Closed Yes", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE,LWPOLYLINE")]
    [InlineData("PLINE 0,-50 60,-50 60,-20  FILLET R 5 60,-30 90,0", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LWPOLYLINE,LWPOLYLINE")]
    [InlineData("STRETCH C 308,-2 312,2  0,0 5,1", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    [InlineData("LAYER M Deep  MATCHPROP 10,0 60,50 ", "CIRCLE,ELLIPSE,LINE,LINE,LINE,LINE,LWPOLYLINE")]
    public async Task A_stranger_finds_what_was_reshaped(string commands, string types)
    {
        using var folder = new TemporaryFolder();
        var (drawing, file) = (folder.PathOf("in.dxf"), folder.PathOf("out.dxf"));
        File.WriteAllBytes(drawing, new DxfText().Header("AC1021", 4).Section("ENTITIES", s_yard).End().ToAscii());
        var run = await CliRun.RunAsync("script", folder.WithFile("reshape.scr", $"OPEN \"{drawing}\"\n{commands}\nSAVEAS \"{file}\"\n"));
        Assert.Equal(ExitCode.Done, run.ExitCode);
        var audit = await AuditAsync(file, folder);

        Assert.Equal((0, 0), (audit.GetProperty("errors").GetInt32(), audit.GetProperty("fixes").GetInt32()));
        Assert.Equal(types, string.Join(',', audit.GetProperty("types").EnumerateArray().Select(type => type.GetString())));
    }

    [EzdxfTheory]
    [InlineData("ELLIPSE")]
    [InlineData("SPLINE")]
    public async Task A_stranger_finds_ellipses_and_splines_in_cl_data(string type)
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf("cl.dxf");
        await CliRun.RunAsync("sequence", Drawing(folder, 4), "--json", "-o", file);
        var audit = await AuditAsync(file, folder);

        Assert.Equal((0, 0), (audit.GetProperty("errors").GetInt32(), audit.GetProperty("fixes").GetInt32()));
        Assert.Contains(type, audit.GetProperty("types").EnumerateArray().Select(name => name.GetString()));
    }

    private static string Drawing(TemporaryFolder folder, int units)
    {
        var path = folder.PathOf("in.dxf");
        File.WriteAllBytes(path, new DxfText().Header("AC1021", units).Section("TABLES", s_layers).Section("ENTITIES", s_curves).End().ToAscii());
        return path;
    }

    private static async Task<string> SavedAsync(TemporaryFolder folder, int units)
    {
        var file = folder.PathOf("out.dxf");
        var run = await CliRun.RunAsync("script", folder.WithFile("save.scr", $"OPEN \"{Drawing(folder, units)}\"\nSAVEAS \"{file}\"\n"));
        Assert.Equal(ExitCode.Done, run.ExitCode);
        return file;
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
