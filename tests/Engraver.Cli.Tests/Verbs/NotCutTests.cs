using System.Globalization;
using System.Text;
using System.Text.Json;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>Visible but uncut entities are reported before the run and in its last line.</summary>
public sealed class NotCutTests
{
    private static readonly (int, object)[] s_line = [(0, "LINE"), (8, "0"), (10, 0.0), (20, 0.0), (11, 10.0), (21, 0.0)];

    private static readonly (int, object)[] s_text = [(0, "TEXT"), (8, "0"), (10, 1.0), (20, 1.0), (40, 2.5), (1, "No 7")];

    [Fact]
    public async Task A_text_that_is_seen_and_not_cut_is_counted_and_said_in_the_last_line()
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. s_line, .. s_text]);

        var json = await CliRun.RunAsync("run", file, "--connect", "sim:", "--json", "--journal", folder.PathOf("j"));
        var said = await CliRun.RunAsync("run", file, "--connect", "sim:", "--quiet", "--journal", folder.PathOf("k"));

        Assert.Equal(0, json.ExitCode);
        Assert.Equal("""{"TEXT":1}""", Compact(JsonText.Of(json).GetProperty("notCut")));
        Assert.Contains("visible but NOT CUT (1 TEXT): name texts with --cut (text)", said.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("the whole drawing was cut", said.Out, StringComparison.Ordinal);
    }

    /// <summary>The plan reports it too, and the last line of a dry run states that nothing was cut.</summary>
    [Fact]
    public async Task The_plan_counts_it_and_a_hatch_is_told_with_the_option_that_cuts_it()
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. s_line, (0, "HATCH"), (8, "0")]);

        Assert.Equal("""{"HATCH":1}""", Compact(JsonText.Of(await CliRun.RunAsync("plan", file, "--json")).GetProperty("notCut")));
        var said = await CliRun.RunAsync("run", file, "--connect", "sim:", "--dry-run", "--quiet", "--journal", folder.PathOf("k"));
        Assert.Contains("DRY RUN, tool off, nothing was cut; visible but NOT CUT (1 HATCH): name outlines with --cut", said.Out, StringComparison.Ordinal);
    }

    /// <summary>--cut accepts no tolerances and points: no advice suggests them.</summary>
    [Theory]
    [InlineData("DIMENSION", "To cut them: name outlines with --cut (dimension). To leave them uncut")]
    [InlineData("TOLERANCE", "To cut them: explode TOLERANCE into lines in the CAD program. To leave them uncut")]
    [InlineData("POINT", "To cut them: drill the points with an operation, or draw a small circle or a short line at each. To leave them uncut")]
    [InlineData("MLINE", "To cut them: name outlines with --cut (mline). To leave them uncut")]
    [InlineData("TRACE", "To cut them: name outlines with --cut (solid). To leave them uncut")]
    public async Task What_can_be_done_depends_on_the_type(string type, string advice)
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. s_line, (0, type), (8, "0"), (10, 0.0), (20, 0.0)]);
        var run = await CliRun.RunAsync("run", file, "--connect", "sim:", "--journal", folder.PathOf("k"));

        Assert.Contains(advice, run.Error, StringComparison.Ordinal);
        Assert.Contains(advice[(advice.IndexOf(':', StringComparison.Ordinal) + 1)..advice.IndexOf('.', StringComparison.Ordinal)], run.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("--cut " + type, run.Out + run.Error, StringComparison.OrdinalIgnoreCase);
    }

    [Theory]
    [InlineData("\"CUT, outer\"", 1)]
    [InlineData("0,\"CUT, outer\"", 2)]
    [InlineData(" \"CUT, outer\" , 0", 2)]
    [InlineData("0", 1)]
    [InlineData("\"say \"\"x\"\"\"", 1)]
    public async Task A_layer_with_a_comma_in_its_name_is_named_in_quotes(string layers, int contours)
    {
        using var folder = new TemporaryFolder();
        (int, object)[] On(string layer, double y) => [(0, "LINE"), (8, layer), (10, 0.0), (20, y), (11, 10.0), (21, y)];
        var run = await CliRun.RunAsync("sequence", Written(folder, [.. On("0", 0.0), .. On("CUT, outer", 20.0), .. On("say \"x\"", 40.0)]), "--layers", layers, "--json");

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(contours, JsonText.Of(run).GetProperty("contours").GetInt32());
    }

    [Theory]
    [InlineData("info")]
    [InlineData("plan")]
    public async Task What_is_not_cut_is_a_diagnostic_that_leaves_the_exit_code_as_it_is(string verb)
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. s_line, .. s_text, .. s_text]);

        var run = await CliRun.RunAsync(verb, file);

        Assert.Equal(0, run.ExitCode);
        Assert.Contains($"{file}(31): warning JOB0001: Visible but not cut: 2 TEXT.", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Nothing_is_said_of_what_stands_on_a_layer_that_is_not_cut()
    {
        using var folder = new TemporaryFolder();
        var bytes = new DxfText().Header("AC1015", 4)
            .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "off"), (70, 0), (62, -7), (0, "LAYER"), (2, "notes"), (70, 0), (62, 7), (0, "ENDTAB"))
            .Section("ENTITIES", [.. s_line, (0, "HATCH"), (8, "off"), (0, "MTEXT"), (8, "notes"), (10, 0.0), (20, 0.0), (40, 1.0), (1, "a"), (0, "TEXT"), (8, "0"), (60, 1), (10, 0.0), (20, 0.0), (40, 1.0), (1, "a")]).End().ToAscii();
        var file = folder.WithFile("layers.dxf", Encoding.UTF8.GetString(bytes));

        Assert.Equal("""{"MTEXT":1}""", await NotCutAsync(folder, file));
        Assert.Equal("{}", await NotCutAsync(folder, file, "--skip-layers", "notes"));
        Assert.Equal("""{"HATCH":1}""", await NotCutAsync(folder, file, "--layers", "0,off"));
    }

    [Fact]
    public async Task What_stands_in_blocks_counts_once_for_every_copy_and_on_the_layer_of_its_insert()
    {
        using var folder = new TemporaryFolder();
        var bytes = new DxfText().Header("AC1015", 4)
            .Section("TABLES", (0, "TABLE"), (2, "LAYER"), (0, "LAYER"), (2, "off"), (70, 0), (62, -7), (0, "LAYER"), (2, "frozen"), (70, 1), (62, 7), (0, "ENDTAB"))
            .Section("BLOCKS",
            [
                (0, "BLOCK"), (8, "0"), (2, "inner"), (10, 0.0), (20, 0.0), (0, "HATCH"), (8, "0"), (0, "SOLID"), (8, "off"), (0, "ATTDEF"), (8, "0"), (10, 0.0), (20, 0.0), (1, "x"), (0, "ENDBLK"),
                (0, "BLOCK"), (8, "0"), (2, "outer"), (10, 0.0), (20, 0.0), .. s_line, .. s_text, (0, "INSERT"), (8, "0"), (2, "inner"), (10, 0.0), (20, 0.0), (70, 2), (71, 3), (44, 5.0), (45, 5.0), (0, "ENDBLK"),
            ])
            .Section("ENTITIES",
            [
                (0, "INSERT"), (8, "0"), (2, "outer"), (10, 0.0), (20, 0.0), (0, "INSERT"), (8, "0"), (2, "outer"), (10, 50.0), (20, 0.0),
                (0, "INSERT"), (8, "off"), (2, "outer"), (10, 90.0), (20, 0.0), (0, "INSERT"), (8, "frozen"), (2, "outer"), (10, 90.0), (20, 0.0),
            ]).End().ToAscii();

        Assert.Equal("""{"HATCH":12,"TEXT":2}""", await NotCutAsync(folder, folder.WithFile("blocks.dxf", Encoding.UTF8.GetString(bytes))));
    }

    [Fact]
    public async Task What_is_cut_because_it_is_asked_for_is_not_told()
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. s_line, (0, "LEADER"), (8, "0"), (76, 2), (10, 0.0), (20, 5.0), (10, 10.0), (20, 5.0)]);

        Assert.Equal("""{"LEADER":1}""", await NotCutAsync(folder, file));
        Assert.Equal("{}", await NotCutAsync(folder, file, "--cut", "leader"));
    }

    [Fact]
    public async Task A_line_that_goes_down_is_told_and_is_not_joined_to_one_at_another_height()
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. Line(0, 0, 0, 10, 0, -2), .. Line(10, 0, 0, 10, 10, 0), .. Line(0, 0, 0, 0, 10, 0)]);

        var run = await CliRun.RunAsync("sequence", file, "--json");

        Assert.Equal(0, run.ExitCode);
        Assert.Equal(2, JsonText.Of(run).GetProperty("contours").GetInt32());
        Assert.Contains("(19): warning JOB0002: Curves that are not level: 1, the first", run.Error, StringComparison.Ordinal);
        Assert.Contains("JOB0003: The curves are at 2 heights, from -2 to 0 mm", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.0, 1e-10, 0)]
    [InlineData(12.5, 1e-10, 1)]
    [InlineData(12.5, 0.0, 1)]
    public async Task Noise_of_heights_is_nothing_and_one_height_is_said_once_as_an_information(double z, double noise, int findings)
    {
        using var folder = new TemporaryFolder();
        var file = Written(folder, [.. Line(0, 0, z, 10, 0, z + noise), .. Line(10, 0, z - noise, 10, 10, z), .. Line(10, 10, z + noise, 0, 0, z)]);

        var run = await CliRun.RunAsync("sequence", file, "--json", "--verbose");

        Assert.Equal(1, JsonText.Of(run).GetProperty("closed").GetInt32());
        Assert.Equal(findings, run.Error.Split('\n').Count(line => line.Contains(": info JOB0004: ", StringComparison.Ordinal)));
        Assert.DoesNotContain("warning", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(6, 30.0, 0.0, "in millimetres, the same numbers give")]
    [InlineData(4, 45000.0, 0.0, "")]
    [InlineData(4, 100.0, 25000.0, "")]
    [InlineData(4, 9000.0, 0.0, null)]
    public async Task A_drawing_too_large_or_too_far_away_says_so_before_it_is_run(int insUnits, double size, double away, string? says)
    {
        using var folder = new TemporaryFolder();
        var bytes = new DxfText().Header("AC1015", insUnits).Section("ENTITIES", Line(away, 0, 0, away + size, size, 0)).End().ToAscii();
        var file = folder.WithFile("large.dxf", Encoding.UTF8.GetString(bytes));

        foreach (var verb in new[] { "info", "plan" })
        {
            var run = await CliRun.RunAsync(verb, file);
            Assert.Equal(0, run.ExitCode);
            if (says is null) Assert.DoesNotContain("JOB000", run.Error, StringComparison.Ordinal);
            else Assert.Contains("warning JOB0005: ", run.Error, StringComparison.Ordinal);
            if (says is not null) Assert.Contains(says, run.Error, StringComparison.Ordinal);
        }
    }

    private static (int, object)[] Line(double x1, double y1, double z1, double x2, double y2, double z2) =>
        [(0, "LINE"), (8, "0"), (10, x1), (20, y1), (30, z1), (11, x2), (21, y2), (31, z2)];

    private static async Task<string> NotCutAsync(TemporaryFolder folder, string file, params string[] options) =>
        Compact(JsonText.Of(await CliRun.RunAsync(["run", file, "--connect", "sim:", "--json", "--dry-run", "--journal", folder.PathOf("j"), .. options])).GetProperty("notCut"));

    private static string Compact(JsonElement element) => JsonSerializer.Serialize(element);

    private static string Written(TemporaryFolder folder, params ReadOnlySpan<(int Code, object Value)> entities) =>
        folder.WithFile(string.Create(CultureInfo.InvariantCulture, $"d{entities.Length}.dxf"), Encoding.UTF8.GetString(DxfText.WithEntities(entities).ToAscii()));
}
