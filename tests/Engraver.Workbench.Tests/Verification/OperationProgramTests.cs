using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.TestKit;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Operations as programs: what the posts write of them, and that a reader finds each difference.</summary>
public class OperationProgramTests
{
    private const string Tools = """[{"number": 1, "name": "V (60)", "diameter": 0.2, "feed": 400, "plunge": 100, "spindle": 18000}, {"number": 3, "name": "End mill", "diameter": 2, "feed": 600, "plunge": 120, "spindle": 9000}]""";

    private const string Milled = """
        { "id": "marks", "name": "Marks", "kind": "engrave", "select": "rest", "tool": 1, "depth": 0.25, "pierce": 0.5 },
        { "id": "holes", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 3, "peck": 1.5, "dwell": 0.25, "feed": 300, "spindle": 6000 },
        { "id": "cut", "kind": "profile", "side": "outside", "select": {"layers": ["CUT"]}, "tool": 3, "depth": 2, "depthPerPass": 1, "leadIn": {"shape": "arc", "radius": 1}, "tabs": {"count": 2, "width": 2, "height": 0.5} }
        """;

    private const string Drawn = """
        { "id": "marks", "kind": "engrave", "select": "rest", "tool": 1 }, { "id": "cut", "kind": "engrave", "select": {"layers": ["CUT"]}, "tool": 3, "repeats": 2 }
        """;

    /// <summary>A pass of 0.2 mm and one of 0.4 mm, which is cut three times.</summary>
    private const string Repeated = """{ "id": "marks", "name": "Marks", "kind": "engrave", "select": "rest", "tool": 1, "depth": 0.4, "depthPerPass": 0.2, "repeats": 3, "stopBetween": true }""";

    private static readonly MachineProfile s_mill = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 1000.0) }, Height = new HeightDrive(), Spindle = new Spindle { SpinUpSeconds = 1.5 } };

    [Fact]
    public void A_program_of_LinuxCNC_loads_each_tool_and_has_the_speeds_waits_and_pecks_of_each_operation()
    {
        var lines = Posted("gcode", Milled, s_mill).Text!.Split('\n');

        Assert.Equal(["(T1 V _60_)", "T1 M6", "G43", "G0 Z5", "M3 S18000", "G4 P1.5", "(Marks)", "G0 X3 Y8", "G0 Z1", "G1 Z-0.25 F100", "G4 P0.5", "G1 X9 Y8 F400", "G0 Z5"], lines.Skip(5).Take(13));
        Assert.Equal(["M5", "(T3 End mill)", "T3 M6", "G43", "G0 Z5", "M3 S6000", "G4 P1.5", "(holes)", "G0 X3 Y3", "G0 Z1", "G1 Z0 F120", "G1 X3 Y3 Z-1.5", "G1 X3 Y3 Z0 F300", "G1 X3 Y3 Z-3 F120", "G4 P0.25", "G0 Z5", "M3 S9000", "G4 P1.5", "(cut)"], lines.Skip(18).Take(19));
        Assert.Equal(["G0 Z5", "M5", "M2", "%", ""], lines[^5..]);
        List<string> outline = [.. lines.Skip(37)];
        Assert.Equal((1, 1, 2), (outline.Count(line => line.StartsWith("G1 Z-1", StringComparison.Ordinal)), outline.Count(line => line.StartsWith("G1 Z-2", StringComparison.Ordinal)), outline.Count(line => line.Contains(" Z-1.5", StringComparison.Ordinal))));
    }

    [Fact]
    public void A_program_of_grbl_stops_for_another_tool_and_names_it()
    {
        var posted = Posted("grbl", Milled, s_mill);

        Assert.Contains("\nM5\n(T3 End mill)\nM0\nG0 Z5\nM3 S6000\n", posted.Text!, StringComparison.Ordinal);
        Assert.DoesNotContain("M6", posted.Text!, StringComparison.Ordinal);
        Assert.Equal(["OPR0035"], posted.Diagnostics.Select(finding => finding.Id).Where(id => id.StartsWith("OPR", StringComparison.Ordinal)));
        Assert.DoesNotContain("M0", Posted("grbl", Milled.Replace("\"tool\": 1", "\"tool\": 3", StringComparison.Ordinal), s_mill).Text!, StringComparison.Ordinal);
    }

    [Fact]
    public void A_plotter_takes_the_pen_of_the_tool_and_no_depths()
    {
        var drawn = Posted("hpgl", Drawn, MachineProfile.Default);

        Assert.Equal(["SP1;", "VS0.6667;", "SP3;", "VS1;", "SP0;"], drawn.Text!.Split('\n').Where(line => line.StartsWith("SP", StringComparison.Ordinal) || line.StartsWith("VS", StringComparison.Ordinal)));
        Assert.Equal(["OPR0014", "OPR0014"], drawn.Diagnostics.Select(finding => finding.Id).Where(id => id.StartsWith("OPR", StringComparison.Ordinal)));
        Assert.Equal((null, 3), (Posted("hpgl", Milled, s_mill).Text, Posted("hpgl", Milled, s_mill).Diagnostics.Count(finding => finding.Id == "OPR0037")));
        Assert.Equal("OPR0037", Assert.Single(PostedProgram.Create(Plate(), Settings(Drawn.Replace("3,", "1,", StringComparison.Ordinal), MachineProfile.Default), PostTable.Find("hpgl").Post, new Dictionary<string, string> { ["pen"] = "2" }).Diagnostics, finding => finding.Severity == Core.Diagnostics.Severity.Error).Id);
    }

    [Fact]
    public void A_speed_that_no_code_of_the_program_sets_is_named()
    {
        Assert.DoesNotContain(Posted("gcode", Drawn, MachineProfile.Default).Diagnostics, finding => finding.Id == "OPR0014");
        var switched = PostedProgram.Create(Plate(), Settings(Drawn, MachineProfile.Default), PostTable.Find("gcode").Post, new Dictionary<string, string> { ["tool-switch"] = "m8" });
        Assert.Equal(2, switched.Diagnostics.Count(finding => finding.Id == "OPR0014"));
    }

    [Theory]
    [InlineData("agie")]
    [InlineData("cldata")]
    [InlineData("xps-pvt")]
    public void Other_formats_refuse_operations_and_say_why(string target) =>
        Assert.Equal("OPR0017", Assert.Single(Posted(target, Drawn, MachineProfile.Default).Diagnostics, finding => finding.Facts.Count == 2 && finding.Facts[1].Length > 20).Id);

    [Theory]
    [InlineData("gcode")]
    [InlineData("grbl")]
    public async Task A_program_of_the_operations_is_accepted(string target) =>
        Assert.True((await VerifyAsync(target, Posted(target, Milled, s_mill).Text!, Settings(Milled, s_mill))).Ok);

    /// <summary>The text of the program is changed.</summary>
    [Theory]
    [InlineData("gcode", "T3 M6", "T1 M6", "VER0013")]
    [InlineData("gcode", "T3 M6\n", "", "VER0013")]
    [InlineData("gcode", "M6\nG43\nG0 Z5\nM3 S6000", "M6\nG0 Z5\nM3 S6000", "VER0013")]
    [InlineData("gcode", "S6000", "S9000", "VER0013")]
    [InlineData("gcode", "G4 P0.5\n", "", "VER0013")]
    [InlineData("gcode", "G4 P0.25\n", "G4 P0.2\n", "VER0013")]
    [InlineData("gcode", "F400", "F600", "VER0010")]
    [InlineData("gcode", "Z-1.5\n", "Z-1.5 F200\n", "VER0010")]
    [InlineData("gcode", "G0 Z5\nM5\n(T3", "M5\n(T3", "PST0001")]
    [InlineData("gcode", "G43\nG0 Z5\nM3 S6000", "G43\nM3 S6000", "PST0001")]
    [InlineData("grbl", "M0\n", "", "VER0013")]
    [InlineData("grbl", "M0\nG0 Z5", "M0\nM0\nG0 Z5", "VER0013")]
    [InlineData("grbl", "M5\n(T3", "(T3", "PST0001")]
    public async Task Another_tool_speed_wait_or_feed_is_found(string target, string was, string becomes, string id)
    {
        var (settings, text) = (Settings(Milled, s_mill), Posted(target, Milled, s_mill).Text!);
        var at = text.IndexOf(was, StringComparison.Ordinal);
        Assert.InRange(at, 0, text.Length);

        var report = await VerifyAsync(target, text[..at] + becomes + text[(at + was.Length)..], settings);

        Assert.Equal((false, id), (report.Ok, report.Diagnostics[0].Id));
    }

    /// <summary>The program is that of other operations: its side, its depth, its passes, its tabs, its leads, its hole.</summary>
    [Theory]
    [InlineData("gcode", "\"side\": \"outside\"", "\"side\": \"inside\"")]
    [InlineData("gcode", "\"depth\": 3,", "\"depth\": 2.9,")]
    [InlineData("gcode", "\"depthPerPass\": 1,", "")]
    [InlineData("gcode", ", \"tabs\": {\"count\": 2, \"width\": 2, \"height\": 0.5}", "")]
    [InlineData("gcode", "\"height\": 0.5", "\"height\": 0.6")]
    [InlineData("gcode", "\"leadIn\": {\"shape\": \"arc\", \"radius\": 1}, ", "")]
    [InlineData("gcode", "\"depth\": 0.25,", "\"depth\": 0.25, \"repeats\": 2,")]
    [InlineData("gcode", "{ \"id\": \"holes\",", "{ \"id\": \"holes\", \"on\": false,")]
    public async Task A_program_of_other_operations_is_found(string target, string was, string becomes)
    {
        Assert.Contains(was, Milled, StringComparison.Ordinal);
        var text = Posted(target, Milled.Replace(was, becomes, StringComparison.Ordinal), s_mill).Text!;

        Assert.False((await VerifyAsync(target, text, Settings(Milled, s_mill))).Ok);
    }

    [Theory]
    [InlineData("SP3;", "SP2;", "VER0013")]
    [InlineData("VS1;", "VS0.5;", "VER0010")]
    public async Task Another_pen_or_speed_of_a_plotter_is_found(string was, string becomes, string id)
    {
        var (settings, text) = (Settings(Drawn, MachineProfile.Default), Posted("hpgl", Drawn, MachineProfile.Default).Text!);
        Assert.True((await VerifyAsync("hpgl", text, settings)).Ok);

        var report = await VerifyAsync("hpgl", text.Replace(was, becomes, StringComparison.Ordinal), settings);

        Assert.Equal((false, id), (report.Ok, report.Diagnostics[0].Id));
    }

    [Fact]
    public async Task A_missing_repeat_is_found_by_the_length_of_the_program()
    {
        var text = Posted("hpgl", Drawn.Replace(", \"repeats\": 2", "", StringComparison.Ordinal), MachineProfile.Default).Text!;

        Assert.Equal("OPR0036", Assert.Single((await VerifyAsync("hpgl", text, Settings(Drawn, MachineProfile.Default))).Diagnostics).Id);
    }

    /// <summary>One file for each tool, with the number of the section where a tool comes twice; together they have every stroke, each as in the job of its
    /// tool.</summary>
    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    public async Task A_Galil_program_is_written_for_each_tool(string target)
    {
        var settings = Settings(Milled, s_mill);
        var programs = ToolProgram.Of(Plate(), settings, PostTable.Find(target).Post, PostedProgram.NoOptions, null);
        var twice = ToolProgram.Of(Plate(), Settings(Milled.Replace("\"side\": \"outside\", \"select\": {\"layers\": [\"CUT\"]}, \"tool\": 3", "\"side\": \"outside\", \"select\": {\"layers\": [\"CUT\"]}, \"tool\": 1", StringComparison.Ordinal), s_mill), PostTable.Find(target).Post, PostedProgram.NoOptions, null);

        Assert.Equal(["a/OUT-T1.dmc", "a/OUT-T3.dmc"], programs.Select(program => program.FileOf("a/OUT.dmc")));
        Assert.Equal(["OUT-T1-1.dmc", "OUT-T3.dmc", "OUT-T1-3.dmc"], twice.Select(program => program.FileOf("OUT.dmc")));
        foreach (var program in programs) Assert.True((await VerifyAsync(target, program.Posted.Text!, settings with { Tool = program.Tool.Number })).Ok);
        Assert.False((await VerifyAsync(target, twice[0].Posted.Text!, Settings(Milled, s_mill) with { Tool = 3 })).Ok);
        Assert.Contains("WT 500;BGS", programs[0].Posted.Text!.Replace("JS#DOWN;WT 500\n", "WT 500;BGS", StringComparison.Ordinal), StringComparison.Ordinal);
        Assert.Empty(ToolProgram.Of(Plate(), settings with { Tool = 3 }, PostTable.Find(target).Post, PostedProgram.NoOptions, null));
        Assert.Equal("OPR0012", Assert.Single(Posted(target, Milled, s_mill).Diagnostics, finding => finding.Severity == Core.Diagnostics.Severity.Error).Id);
    }

    /// <summary>The program stops before each repeat, with the spindle off, and a reader finds a stop that is missing, in the work, or one too many.</summary>
    [Theory]
    [InlineData("gcode", "", "", null)]
    [InlineData("grbl", "", "", null)]
    [InlineData("gcode", "M0\n", "", "VER0013")]
    [InlineData("grbl", "M0\n", "M0\nM0\nM0\n", "VER0013")]
    [InlineData("grbl", "M5\n(Repeat 2", "(Repeat 2", "PST0001")]
    [InlineData("grbl", "M0\n", "T1 M6\n", "PST0001")]
    [InlineData("gcode", "M0\n", "T1 M6\n", "PST0001")]
    public async Task A_program_of_G_code_stops_between_repeats(string target, string was, string becomes, string? id)
    {
        var text = Posted(target, Repeated, s_mill).Text!;
        Assert.Equal(2, text.Split("\nM0\n").Length - 1);
        Assert.Contains("G0 Z5\nM5\n(Repeat 2 of 3 Marks)\nM0\nM3 S18000\nG4 P1.5\n", text, StringComparison.Ordinal);
        Assert.DoesNotContain(Posted(target, Repeated, s_mill).Diagnostics, finding => finding.Id == "OPR0035");

        var at = text.IndexOf(was, StringComparison.Ordinal);
        var report = await VerifyAsync(target, was.Length == 0 ? text : text[..at] + becomes + text[(at + was.Length)..], Settings(Repeated, s_mill));

        Assert.Equal((id is null, id), (report.Ok, report.Diagnostics.Select(finding => finding.Id).FirstOrDefault()));
    }

    /// <summary>A stop between repeats with one tool and a change of the tool after it.</summary>
    [Theory]
    [InlineData("gcode", "(T1 V _60_)|T1 M6|M0|(T3 End mill)|T3 M6")]
    [InlineData("grbl", "(T1 V _60_)|M0|(T3 End mill)|M0")]
    public async Task A_stop_is_not_a_change_of_the_tool(string target, string breaks)
    {
        var operations = Repeated.Replace("\"repeats\": 3", "\"repeats\": 2", StringComparison.Ordinal) + ", " + """{ "id": "cut", "kind": "engrave", "select": {"layers": ["CUT"]}, "tool": 3, "depth": 2 }""";
        var text = Posted(target, operations, s_mill).Text!;

        Assert.Equal(breaks, string.Join('|', text.Split('\n').Where(line => line.StartsWith("(T", StringComparison.Ordinal) || line is "M0" || line.Contains("M6", StringComparison.Ordinal))));
        Assert.True((await VerifyAsync(target, text, Settings(operations, s_mill))).Ok);
        Assert.False((await VerifyAsync(target, text.Replace("\n(Repeat 2 of 2 Marks)\nM0", "", StringComparison.Ordinal), Settings(operations, s_mill))).Ok);
    }

    /// <summary>A Galil program cannot stop for the operator: a program for each repeat, each of which is verified as its section; the certificate is that of
    /// the motion of all.</summary>
    [Fact]
    public async Task Repeats_with_a_stop_are_Galil_programs_of_their_own()
    {
        var settings = Settings(Repeated, s_mill);
        var entry = PostTable.Find("galil");
        var programs = ToolProgram.Of(Plate(), settings, entry.Post, PostedProgram.NoOptions, null);

        Assert.Equal(["OUT-T1-1.dmc", "OUT-T1-2.dmc", "OUT-T1-3.dmc"], programs.Select(program => program.FileOf("OUT.dmc")));
        for (var i = 0; i < 3; i++) Assert.Equal([i == 0, i > 0], [(await VerifySectionAsync(programs[i], 1)).Ok, (await VerifySectionAsync(programs[i], 2)).Ok]);
        Assert.Equal("OPR0056", Assert.Single(Posted("galil", Repeated, s_mill).Diagnostics, finding => finding.Severity == Core.Diagnostics.Severity.Error).Id);
        Assert.Equal("OPR0037", Assert.Single(Posted("hpgl", Drawn.Replace("\"repeats\": 2", "\"repeats\": 2, \"stopBetween\": true", StringComparison.Ordinal), MachineProfile.Default).Diagnostics, finding => finding.Severity == Core.Diagnostics.Severity.Error).Id);
        await Assert.ThrowsAsync<SettingException>(() => VerifySectionAsync(programs[0], 4));
        var certified = await Certification.CertifyAsync(new CertificationRequest(Plate(), null, settings, entry, DateTimeOffset.UnixEpoch), null, CancellationToken.None);
        Assert.True(certified.Certificate is { Ok: true, Operations: [{ Depths.Count: 4 }] }, certified.NoProgramReason);

        Task<VerificationReport> VerifySectionAsync(ToolProgram program, int section) => ProgramVerification.VerifyAsync(ReadBackFile.FromText(program.Posted.Text!), entry.Reader!, Plate(), settings, progress: null, CancellationToken.None, new PostParameters { Section = section });
    }

    private static PostedProgram Posted(string target, string operations, MachineProfile machine) => PostedProgram.Create(
        Plate(), Settings(operations, machine), PostTable.Find(target == "grbl" ? "gcode" : target).Post, target == "grbl" ? new Dictionary<string, string> { ["dialect"] = "grbl" } : PostedProgram.NoOptions);

    private static Task<VerificationReport> VerifyAsync(string target, string text, DrawingSettings settings) => ProgramVerification.VerifyAsync(
        ReadBackFile.FromText(text), target == "grbl" ? PostTable.Find("gcode").Dialects["grbl"] : PostTable.Find(target).Reader!, Plate(), settings, progress: null, CancellationToken.None);

    private static DrawingSettings Settings(string operations, MachineProfile machine) => new() { Machine = machine, Operations = OperationFile.Parse($"{{ \"version\": \"1.0\", \"tools\": {Tools}, \"operations\": [{operations}] }}") };

    private static Drawing Plate() => new DrawingBuilder().OnLayer(Visible("CUT")).Square(0, 0, 12).OnLayer(Visible("HOLES")).Circle(3, 3, 1).OnLayer(Visible("MARK")).Line(3, 8, 9, 8).Build();

    private static Layer Visible(string name) => new(name, On: true, Frozen: false, Plot: true);
}
