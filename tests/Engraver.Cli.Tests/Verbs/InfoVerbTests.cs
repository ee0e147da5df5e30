namespace Engraver.Cli.Tests.Verbs;

public class InfoVerbTests
{
    [Fact]
    public async Task The_object_has_every_field_of_the_contract()
    {
        var info = JsonText.Of(await CliRun.RunAsync("info", SampleDrawing.PathOf("nameplate"), "--json"));

        Assert.Equal(
            ["file", "bytes", "dxfVersion", "encoding", "units", "entities", "balance", "primitives", "leaf", "text", "length", "bounds", "layers", "diagnostics", "texts"],
            info.EnumerateObject().Select(field => field.Name));
        Assert.Equal("AC1032", info.GetProperty("dxfVersion").GetString());
        Assert.Equal(1.0, info.GetProperty("units").GetProperty("toMillimetres").GetDouble());
        Assert.Equal(1, info.GetProperty("text").GetProperty("TEXT").GetInt32());
    }

    [Fact]
    public async Task Everything_read_is_cut_construction_or_refused()
    {
        foreach (var name in SampleDrawing.Names)
        {
            var info = JsonText.Of(await CliRun.RunAsync("info", SampleDrawing.PathOf(name), "--json"));
            var balance = info.GetProperty("balance");

            Assert.Equal(
                balance.GetProperty("read").GetInt32(),
                balance.GetProperty("cut").GetInt32() + balance.GetProperty("construction").GetInt32() + balance.GetProperty("refused").GetArrayLength());
            Assert.Equal(balance.GetProperty("read").GetInt32(), info.GetProperty("entities").EnumerateObject().Sum(type => type.Value.GetInt32()));
        }
    }

    [Fact]
    public async Task Binary_and_inches_are_recognised()
    {
        var dial = JsonText.Of(await CliRun.RunAsync("info", SampleDrawing.PathOf("clock-dial"), "--json"));
        var gasket = JsonText.Of(await CliRun.RunAsync("info", SampleDrawing.PathOf("gasket"), "--json"));

        Assert.Equal("binary", dial.GetProperty("encoding").GetString());
        Assert.Equal(25.4, gasket.GetProperty("units").GetProperty("toMillimetres").GetDouble());
    }

    [Fact]
    public async Task A_curve_that_cannot_be_read_is_an_error_and_the_rest_is_read_all_the_same()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("body.dxf", "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n5\n2F\n8\n0\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n4\n0\nENDSEC\n0\nEOF\n");
        var run = await CliRun.RunAsync("info", file, "--json");
        var refused = JsonText.Of(run).GetProperty("balance").GetProperty("refused")[0];

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Equal("SPLINE", refused.GetProperty("type").GetString());
        Assert.Equal("2F", refused.GetProperty("handle").GetString());
        Assert.Equal(5, refused.GetProperty("line").GetInt32());
        Assert.Equal(5.0, JsonText.Of(run).GetProperty("length").GetProperty("total").GetDouble());
    }

    [Fact]
    public async Task Texts_are_told_with_content_and_place()
    {
        var text = JsonText.Of(await CliRun.RunAsync("info", SampleDrawing.PathOf("nameplate"), "--json")).GetProperty("texts")[0];

        Assert.Equal("TEXT", text.GetProperty("type").GetString());
        Assert.NotEmpty(text.GetProperty("content").GetString()!);
        Assert.True(text.GetProperty("height").GetDouble() > 0.0);
    }

    [Fact]
    public async Task Construction_is_cut_when_it_is_named()
    {
        using var folder = new TemporaryFolder();
        var file = folder.WithFile("solid.dxf", "0\nSECTION\n2\nENTITIES\n0\nSOLID\n10\n0\n20\n0\n11\n3\n21\n0\n12\n0\n22\n4\n0\nENDSEC\n0\nEOF\n");
        var without = JsonText.Of(await CliRun.RunAsync("info", file, "--json", "--units", "mm"));
        var with = JsonText.Of(await CliRun.RunAsync("info", file, "--json", "--units", "mm", "--cut", "hatch,solid"));

        Assert.Equal((0, 1), (without.GetProperty("balance").GetProperty("cut").GetInt32(), without.GetProperty("balance").GetProperty("construction").GetInt32()));
        Assert.Equal((1, 0), (with.GetProperty("balance").GetProperty("cut").GetInt32(), with.GetProperty("balance").GetProperty("construction").GetInt32()));
        Assert.Equal(12.0, with.GetProperty("length").GetProperty("total").GetDouble(), 12);
        Assert.Equal(3, JsonText.Of(await CliRun.RunAsync("sequence", file, "--json", "--cut", "solid")).GetProperty("segments").GetInt32());
    }

    [Fact]
    public async Task A_second_reading_agrees_with_every_sample()
    {
        foreach (var name in SampleDrawing.Names)
        {
            var run = await CliRun.RunAsync("info", SampleDrawing.PathOf(name), "--twice", "--json");

            Assert.Contains("the second reading agrees", run.Error, StringComparison.Ordinal);
            Assert.Equal(ExitCode.Done, run.ExitCode);
        }
    }

    [Fact]
    public async Task Where_the_two_readings_differ_it_is_said_and_is_exit_1()
    {
        using var folder = new TemporaryFolder();
        var comma = folder.WithFile("comma.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n1,5\n20\n0\n11\n3\n21\n0\n0\nENDSEC\n0\nEOF\n");
        var run = await CliRun.RunAsync("info", comma, "--twice", "--units", "mm");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Contains("second reading differs: LINE: 1 curves, the second reading has 0", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Quiet_says_nothing_about_warnings_and_the_culture_changes_no_number()
    {
        var loud = await CliRun.RunAsync("info", SampleDrawing.PathOf("pcb-outline"), "--json");
        var quiet = await CliRun.RunAsync("info", SampleDrawing.PathOf("pcb-outline"), "--json", "--quiet", "--culture", "fr-FR");

        Assert.Contains("warning", loud.Error, StringComparison.Ordinal);
        Assert.Empty(quiet.Error);
        Assert.Equal(loud.Out, quiet.Out);
    }
}
