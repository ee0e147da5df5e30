using System.Diagnostics;
using System.Globalization;
using System.Text.Json;

namespace Engraver.Cli.Tests.Posts;

/// <summary>The sequenced drawing as a file, read by this program and by ezdxf.</summary>
public class ClDataFileTests
{
    /// <summary>Errors, errors repaired while reading, entities, length of lines and of arcs and circles, unit.</summary>
    private const string Audit = """
        import sys, json, math, ezdxf
        from ezdxf import recover
        strict = ezdxf.readfile(sys.argv[1])
        document, auditor = recover.readfile(sys.argv[1])
        again = strict.audit()
        space = strict.modelspace()
        cut = [e for e in space if e.dxf.layer != "RAPID"]
        sweep = lambda e: 360.0 if e.dxftype() == "CIRCLE" else ((e.dxf.end_angle - e.dxf.start_angle - 1e-12) % 360.0) + 1e-12
        length = sum((e.dxf.end - e.dxf.start).magnitude if e.dxftype() == "LINE" else e.dxf.radius * math.radians(sweep(e)) for e in cut)
        numbers = [e.get_xdata("CNCENGRAVER")[1].value for e in cut]
        print(json.dumps({"errors": len(auditor.errors) + len(again.errors), "fixes": len(auditor.fixes) + len(again.fixes), "cut": len(cut), "length": length,
                          "inOrder": numbers == list(range(1, len(cut) + 1)), "units": strict.header["$INSUNITS"], "version": strict.dxfversion}))
        """;

    public static TheoryData<string> Samples => new(SampleDrawing.Names);

    [EzdxfTheory]
    [MemberData(nameof(Samples))]
    public async Task A_stranger_opens_it_without_errors_and_finds_the_same_path(string name)
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf("cl.dxf");
        var sequence = JsonText.Of(await CliRun.RunAsync("sequence", SampleDrawing.PathOf(name), "--json", "-o", file));
        var audit = await AuditAsync(file, folder);

        Assert.Equal((0, 0), (audit.GetProperty("errors").GetInt32(), audit.GetProperty("fixes").GetInt32()));
        Assert.Equal((4, "AC1015"), (audit.GetProperty("units").GetInt32(), audit.GetProperty("version").GetString()));
        Assert.True(audit.GetProperty("inOrder").GetBoolean());
        Assert.Equal(sequence.GetProperty("pathLength").GetDouble(), audit.GetProperty("length").GetDouble(), 1e-6);
    }

    [Theory]
    [MemberData(nameof(Samples))]
    public async Task Reading_it_again_in_drawn_order_gives_the_same_strokes(string name)
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf("cl.dxf");
        var before = JsonText.Of(await CliRun.RunAsync("sequence", SampleDrawing.PathOf(name), "--json", "-o", file));
        var after = JsonText.Of(await CliRun.RunAsync("sequence", file, "--json", "--order", "drawn"));

        foreach (var count in new[] { "contours", "closed", "open", "segments" }) Assert.Equal(before.GetProperty(count).GetInt32(), after.GetProperty(count).GetInt32());
        Assert.Equal(before.GetProperty("pathLength").GetDouble(), after.GetProperty("pathLength").GetDouble(), 1e-6);
        Assert.Equal(0, after.GetProperty("reversed").GetInt32());
    }

    [Fact]
    public async Task Posting_cldata_gives_the_same_bytes_as_sequencing_does()
    {
        using var folder = new TemporaryFolder();
        var file = folder.PathOf("cl.dxf");
        await CliRun.RunAsync("sequence", SampleDrawing.PathOf("gasket"), "--json", "-o", file);
        var posted = await CliRun.RunAsync("post", SampleDrawing.PathOf("gasket"), "--target", "cldata");

        Assert.Equal(ExitCode.Done, posted.ExitCode);
        Assert.Equal(await File.ReadAllTextAsync(file), posted.Out);
    }

    [Fact]
    public async Task A_place_that_cannot_be_written_is_a_usage_error()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("sequence", SampleDrawing.PathOf("paper-001"), "-o", folder.PathOf("missing/cl.dxf"));

        Assert.Equal(ExitCode.Usage, run.ExitCode);
    }

    private static async Task<JsonElement> AuditAsync(string file, TemporaryFolder folder)
    {
        var start = new ProcessStartInfo(EzdxfTheoryAttribute.Python, [folder.WithFile("audit.py", Audit), file]) { RedirectStandardOutput = true };
        start.Environment["XDG_CACHE_HOME"] = Path.GetDirectoryName(file);
        using var process = Process.Start(start)!;
        var text = await process.StandardOutput.ReadToEndAsync();
        await process.WaitForExitAsync();
        Assert.True(process.ExitCode == 0, string.Create(CultureInfo.InvariantCulture, $"ezdxf gave up with {process.ExitCode}"));
        return JsonDocument.Parse(text).RootElement;
    }
}
