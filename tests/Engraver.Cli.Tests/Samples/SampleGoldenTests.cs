using System.Text.Json.Nodes;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Samples.Drawings;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Samples;

/// <summary>Output of every stage for the samples, compared with the files in samples/expected; `./test --update-golden` rewrites them.</summary>
public class SampleGoldenTests
{
    public static TheoryData<string> Names => [.. SampleDrawing.Names];

    [Theory]
    [MemberData(nameof(Names))]
    public async Task The_table_in_sequence_order(string name) => Check(name, "table.csv", (await RunAsync("table", name, "--format", "csv")).Out);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task Contours_order_and_discontinuities(string name)
    {
        var sequence = JsonNode.Parse((await RunAsync("sequence", name, "--json")).Out)!.AsObject();
        Assert.True(sequence.Remove("seconds"));

        Check(name, "sequence.json", sequence + "\n");
    }

    [Theory]
    [MemberData(nameof(Names))]
    public async Task The_posted_sequences(string name) => Check(name, "galil.dmc", (await RunAsync("post", name, "--target", "galil")).Out);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task The_posted_calls(string name) => Check(name, "galil-calls.dmc", (await RunAsync("post", name, "--target", "galil-calls")).Out);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task The_posted_blocks_for_the_wire_eroder(string name) => Check(name, "agie", (await RunAsync("post", name, "--target", "agie")).Out);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task The_posted_text_of_every_other_target(string name)
    {
        Check(name, "gcode.ngc", (await RunAsync("post", name, "--target", "gcode")).Out);
        Check(name, "grbl.ngc", (await RunAsync("post", name, "--target", "gcode", "--dialect", "grbl")).Out);
        Check(name, "hpgl.plt", (await RunAsync("post", name, "--target", "hpgl")).Out);
        Check(name, "cldata.dxf", (await RunAsync("post", name, "--target", "cldata")).Out);
        foreach (var target in (string[])["xps-linearc", "xps-spline", "xps-pvt"]) Check(name, target.Replace("-", "", StringComparison.Ordinal), (await RunAsync("post", name, "--target", target)).Out);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public async Task The_picture_of_the_path(string name)
    {
        using var folder = new TemporaryFolder();
        await RunAsync("plot", name, "-o", folder.PathOf("path.svg"));

        Check(name, "path.svg", await File.ReadAllTextAsync(folder.PathOf("path.svg")));
    }

    [Fact]
    public void The_default_machine_profile_shows_every_field() =>
        GoldenFile.Check(Path.Combine(RepositoryFolder.Samples, "machine-default.json"), MachineProfileFile.Write(MachineProfile.Default));

    [Fact]
    public void The_generator_writes_every_sample_byte_for_byte_as_it_stands()
    {
        using var folder = new TemporaryFolder();
        foreach (var sample in Sample.All)
        {
            sample.WriteTo(folder.PathOf(""));

            Assert.Equal(File.ReadAllBytes(Path.Combine(RepositoryFolder.Samples, sample.FileName)), File.ReadAllBytes(folder.PathOf(sample.FileName)));
        }

        Assert.Equal(SampleDrawing.Names, Sample.All.Select(sample => Path.GetFileNameWithoutExtension(sample.FileName)).Order(StringComparer.Ordinal));
    }

    private static async Task<CliRun> RunAsync(string verb, string name, params string[] options)
    {
        var run = await CliRun.RunAsync([verb, SampleDrawing.PathOf(name), .. options]);
        Assert.Equal(ExitCode.Done, run.ExitCode);
        return run;
    }

    private static void Check(string name, string what, string actual) =>
        GoldenFile.Check(Path.Combine(RepositoryFolder.Samples, "expected", $"{name}.{what}"), actual);
}
