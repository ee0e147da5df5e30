using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Runs;

/// <summary>Series of plates with serial numbers: what is spent, confirmed and engraved, also when a plate is interrupted. Each test has a counter of its own,
/// because the tests share the operator's data folder.</summary>
public sealed class SeriesRunTests : IDisposable
{
    private const int Tool = 1;
    private const string Names = "NAME\nAda\nBob\nCyd\nDan\nEve\n";
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(180);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Each_row_is_a_plate_with_its_number_its_journal_and_its_history()
    {
        var run = await CliRun.Typing("\n\n", [.. Series("whole"), "--rows", "2-4"]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        var plates = Plates(run);
        Assert.Equal(["whole=5, csv row 2: NAME=Bob", "whole=7, csv row 3: NAME=Cyd", "whole=9, csv row 4: NAME=Dan"], plates.Select(plate => plate.GetProperty("text").GetString()));
        Assert.All(plates, plate => Assert.Equal(("complete", 0.0), (plate.GetProperty("outcome").GetString(), plate.GetProperty("missingLength").GetDouble())));
        Assert.Equal(9, JsonText.Of(run).GetProperty("plate").GetProperty("values").GetProperty("counters").GetProperty("whole").GetInt64());
        Assert.Contains("Place the next blank for plate 3 of 3 (whole=9", run.Error, StringComparison.Ordinal);
        Assert.Contains("Cyd", await File.ReadAllTextAsync(plates[1].GetProperty("journal").GetString()!), StringComparison.Ordinal);
        var history = JsonText.Of(await CliRun.RunAsync("history", "--search", "whole=7", "--json")).GetProperty("entries");
        Assert.Equal("whole=7, csv row 3: NAME=Cyd", Assert.Single(history.EnumerateArray()).GetProperty("plate").GetString());
        Assert.Equal((11, 0), await CounterAsync("whole"));
        var page = _folder.PathOf("plate.html");
        var report = await CliRun.RunAsync("report", Drawing("whole"), "--cut", "text", "-o", page, "--journal", plates[1].GetProperty("journal").GetString()!);
        Assert.True(report.ExitCode == ExitCode.Done, report.Error); // also: the trace is that of this plate
        Assert.DoesNotContain("trace", report.Error, StringComparison.OrdinalIgnoreCase);
        Assert.Contains("whole=7, csv row 3: NAME=Cyd", await File.ReadAllTextAsync(page), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Without_input_the_series_ends_before_the_next_blank_and_nothing_more_is_spent()
    {
        var run = await CliRun.RunAsync(Series("noinput"));

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (run.ExitCode, Outcome(run)));
        Assert.Single(Plates(run));
        Assert.Contains("--rows 2,3,4,5", run.Error, StringComparison.Ordinal);
        Assert.Equal((7, 0), await CounterAsync("noinput"));
    }

    [Fact]
    public async Task Ctrl_C_between_two_plates_leaves_no_plate_unfinished()
    {
        using var stop = new CancellationTokenSource();
        using var input = new StoppingReader(stop);
        var run = await CliRun.Typing(input, stop.Token, Series("between"));

        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (run.ExitCode, Outcome(run)));
        Assert.Equal("complete", Assert.Single(Plates(run)).GetProperty("outcome").GetString());
        Assert.Contains("--rows 2,3,4,5", run.Error, StringComparison.Ordinal);
        Assert.Equal((7, 0), await CounterAsync("between"));
    }

    [Fact]
    public async Task A_plate_that_was_stopped_is_resumed_with_its_number_and_the_series_continues()
    {
        var stopped = await InPlateThreeAsync(stop => stop.Cancel(), Series("stopped"));
        Assert.Equal((ExitCode.StoppedByOperator, "stopped"), (stopped.ExitCode, Outcome(stopped)));
        Assert.Equal(["complete", "complete", "stopped"], Plates(stopped).Select(plate => plate.GetProperty("outcome").GetString()));
        var journal = Plates(stopped)[2].GetProperty("journal").GetString()!;
        Assert.Contains("--resume " + journal, stopped.Error, StringComparison.Ordinal);
        Assert.Equal((11, 1), await CounterAsync("stopped"));

        var refused = await CliRun.RunAsync([.. Series("stopped"), "--rows", "3-"]);
        Assert.Equal((ExitCode.Usage, "refused"), (refused.ExitCode, Outcome(refused)));
        Assert.Contains("SER0022", refused.Error, StringComparison.Ordinal);
        Assert.Contains(journal, refused.Error, StringComparison.Ordinal);
        Assert.Equal((11, 1), await CounterAsync("stopped"));

        var resumed = await CliRun.Typing("\n\n", [.. Series("stopped"), "--resume", journal]);
        Assert.True(resumed.ExitCode == ExitCode.Done, resumed.Error);
        Assert.Equal(["stopped=9, csv row 3: NAME=Cyd", "stopped=11, csv row 4: NAME=Dan", "stopped=13, csv row 5: NAME=Eve"], Plates(resumed).Select(plate => plate.GetProperty("text").GetString()));
        Assert.All(Plates(resumed), plate => Assert.Equal(0.0, plate.GetProperty("missingLength").GetDouble()));
        Assert.Equal((15, 0), await CounterAsync("stopped"));
    }

    [Fact]
    public async Task A_plate_is_resumed_alone_without_its_CSV_file()
    {
        var stopped = await InPlateThreeAsync(stop => stop.Cancel(), Series("alone"));
        var journal = Plates(stopped)[2].GetProperty("journal").GetString()!;
        string[] resume = ["run", Drawing("alone"), "--cut", "text", "--connect", "sim:", "--json", "--resume", journal];

        var resumed = await CliRun.RunAsync(resume);

        Assert.True(resumed.ExitCode == ExitCode.Done, resumed.Error);
        Assert.Equal("alone=9, csv row 3: NAME=Cyd", JsonText.Of(resumed).GetProperty("plate").GetProperty("text").GetString());
        Assert.Equal(JsonValueKind.Null, JsonText.Of(resumed).GetProperty("plates").ValueKind);
        Assert.Equal((11, 0), await CounterAsync("alone"));
        var twice = await CliRun.RunAsync(resume);
        Assert.True(twice.ExitCode == ExitCode.Usage, twice.Error); // it is engraved now
    }

    [Theory]
    [InlineData("again", 9)]
    [InlineData("next", 11)]
    public async Task After_a_lost_link_the_number_is_engraved_again_or_left_out(string choice, int number)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var counter = "lost" + choice;
        var lost = await InPlateThreeAsync(_ => controller.DropConnections(), Series(counter, await AddressAsync(controller)));
        Assert.True(lost.ExitCode == ExitCode.LinkLost, lost.Error);
        Assert.Equal((11, 1), await CounterAsync(counter));

        var run = await CliRun.Typing("\n\n", [.. Series(counter), "--rows", "3-", "--counter", choice]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal([number, number + 2, number + 4], Plates(run).Select(plate => plate.GetProperty("values").GetProperty("counters").GetProperty(counter).GetInt32()));
        Assert.Equal((number + 6, choice == "next" ? 1 : 0), await CounterAsync(counter));
    }

    [Theory]
    [InlineData("again", 9)]
    [InlineData("next", 11)]
    public async Task The_same_command_continues_with_the_row_of_the_unfinished_plate(string choice, int number)
    {
        var counter = "same" + choice;
        await InPlateThreeAsync(stop => stop.Cancel(), Series(counter));
        Assert.Equal((11, 1), await CounterAsync(counter));

        var planned = await CliRun.RunAsync("plan", Drawing(counter), "--cut", "text", "--csv", Csv(), "--counter", choice);
        Assert.Contains($"Plate 3 of 5: {counter}={number}, csv row 3: NAME=Cyd", planned.Out, StringComparison.Ordinal);
        var run = await CliRun.Typing("\n\n", [.. Series(counter), "--counter", choice]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal([$"{counter}={number}, csv row 3: NAME=Cyd", $"{counter}={number + 2}, csv row 4: NAME=Dan", $"{counter}={number + 4}, csv row 5: NAME=Eve"], Plates(run).Select(plate => plate.GetProperty("text").GetString()));
        Assert.Contains("The series continues with plate 3 of 5", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_series_without_the_row_of_the_unfinished_plate_is_refused()
    {
        await InPlateThreeAsync(stop => stop.Cancel(), Series("norow"));
        var csv = _folder.WithFile("other.csv", Names.Replace("Cyd", "Cyril", StringComparison.Ordinal));
        string[] changed = [.. Series("norow").Select(word => word == Csv() ? csv : word)];
        foreach (var args in (string[][])[[.. Series("norow"), "--rows", "4-", "--counter", "again"], [.. changed, "--counter", "again"], [.. changed, "--counter", "next"]])
        {
            var refused = await CliRun.RunAsync(args);
            Assert.Equal((ExitCode.Usage, "refused"), (refused.ExitCode, Outcome(refused)));
            Assert.Contains("SER0028", refused.Error, StringComparison.Ordinal);
            Assert.Equal((11, 1), await CounterAsync("norow"));
        }

        var selected = await CliRun.Typing("\n", [.. Series("norow"), "--rows", "4-", "--counter", "next"]);
        Assert.True(selected.ExitCode == ExitCode.Done, selected.Error);
        Assert.Equal(["norow=11, csv row 4: NAME=Dan", "norow=13, csv row 5: NAME=Eve"], Plates(selected).Select(plate => plate.GetProperty("text").GetString()));
    }

    [Fact]
    public async Task Copies_continue_with_the_unfinished_one_in_its_place()
    {
        string[] copies = ["run", _folder.WithFile("copies.dxf", Encoding.UTF8.GetString(Plate("[[copy]] [[n again-copies]]"))), "--cut", "text", "--copies", "4", "--connect", "sim:", "--json"];
        await InPlateThreeAsync(stop => stop.Cancel(), copies);

        var run = await CliRun.Typing("\n", [.. copies, "--counter", "again"]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(["again-copies=3, copy=3", "again-copies=4, copy=4"], Plates(run).Select(plate => plate.GetProperty("text").GetString()));
    }

    [Fact]
    public async Task A_killed_program_leaves_its_plate_unfinished_and_the_plate_is_resumed()
    {
        using var patience = new CancellationTokenSource(s_patience);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = 20 });
        var series = Series("killed", await AddressAsync(controller));
        using (var host = EngraverProcess.Start(series))
        {
            await host.In.WriteLineAsync();
            await host.In.FlushAsync(patience.Token);
            while (await host.Error.ReadLineAsync(patience.Token) is { } line && !line.Contains("for plate 3", StringComparison.Ordinal)) Assert.NotNull(line);
            Assert.Equal((9, 0), await CounterAsync("killed")); // nothing is spent for a blank that is not there
            await host.In.WriteLineAsync();
            await host.In.FlushAsync(patience.Token);
            await controller.WaitUntilAsync(status => status.IsMoving && (status.Outputs & Tool) != 0, patience.Token);
            Assert.Equal((11, 1), await CounterAsync("killed")); // spent before the first motion
            host.Kill();
            await host.WaitAsync(patience.Token);
        }

        await controller.WaitUntilAsync(status => !status.IsMoving && (status.Outputs & Tool) == 0, patience.Token);
        var refused = await CliRun.RunAsync([.. series, "--rows", "3-"]);
        Assert.Equal(ExitCode.Usage, refused.ExitCode);
        Assert.Contains("SER0022", refused.Error, StringComparison.Ordinal);
        var journal = JsonText.Of(await CliRun.RunAsync("counters", "--json")).GetProperty("plates").EnumerateArray().Single(plate => plate.GetProperty("numbers").TryGetProperty("killed", out _)).GetProperty("journal").GetString()!;

        var resumed = await CliRun.Typing("\n\n", [.. series, "--resume", journal]);

        Assert.True(resumed.ExitCode == ExitCode.Done, resumed.Error);
        Assert.Equal(["killed=9, csv row 3: NAME=Cyd", "killed=11, csv row 4: NAME=Dan", "killed=13, csv row 5: NAME=Eve"], Plates(resumed).Select(plate => plate.GetProperty("text").GetString()));
        Assert.Equal((15, 0), await CounterAsync("killed"));
    }

    [Fact]
    public async Task Plates_of_a_grid_are_cut_in_their_cells_of_one_blank()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var run = await CliRun.Typing("\n", [.. Series("grid", await AddressAsync(controller)), "--grid", "2x2", "--pitch", "70,-25"]);

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal([(0.0, 0.0), (70.0, 0.0), (0.0, -25.0), (70.0, -25.0), (0.0, 0.0)], Plates(run).Select(plate => (plate.GetProperty("x").GetDouble(), plate.GetProperty("y").GetDouble())));
        Assert.Contains("for plate 5 of 5", run.Error, StringComparison.Ordinal); // the only stop
        Assert.DoesNotContain("for plate 4 of 5", run.Error, StringComparison.Ordinal);
        var cut = controller.Record.Snapshot().Where(row => (row.Outputs & Tool) != 0).ToList();
        Assert.Equal((0, 130_000, -25_000, 20_000), (cut.Min(row => row.A), cut.Max(row => row.A), cut.Min(row => row.B), cut.Max(row => row.B)));
    }

    [Fact]
    public async Task A_blank_is_continued_at_its_next_cell()
    {
        var run = await CliRun.Typing("\n", [.. Series("cells"), "--rows", "3-", "--grid", "3x1", "--pitch", "70,0", "--first-cell", "3"]);
        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal([140.0, 0.0, 70.0], Plates(run).Select(plate => plate.GetProperty("x").GetDouble()));
        Assert.Contains("for plate 2 of 3", run.Error, StringComparison.Ordinal); // the only stop
        Assert.DoesNotContain("for plate 3 of 3", run.Error, StringComparison.Ordinal);

        var ended = await CliRun.RunAsync([.. Series("cells"), "--grid", "3x1", "--pitch", "70,0", "--first-cell", "2"]);
        Assert.Equal(ExitCode.StoppedByOperator, ended.ExitCode);
        Assert.Contains("--rows 3,4,5 --first-cell 1.", ended.Error, StringComparison.Ordinal);
        var copies = await CliRun.RunAsync("plan", Drawing("cells"), "--cut", "text", "--csv", Csv(), "--rows", "1", "--grid", "2x2", "--pitch", "70,30", "--first-cell", "4", "--json");
        Assert.Equal((70.0, 30.0), (Plates(copies)[0].GetProperty("x").GetDouble(), Plates(copies)[0].GetProperty("y").GetDouble()));
    }

    [Fact]
    public async Task A_plate_that_cannot_start_prevents_those_before_it()
    {
        var machine = _folder.WithFile("small.json", """{"travelX": {"min": 0, "max": 100}, "travelY": {"min": 0, "max": 100}}""");
        var run = await CliRun.RunAsync([.. Series("beyond"), "--grid", "3x1", "--pitch", "70,0", "--machine", machine]);

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Equal(["refused"], Plates(run).Select(plate => plate.GetProperty("outcome").GetString()));
        Assert.Contains("JOB0030", run.Error, StringComparison.Ordinal);
        Assert.Contains("--rows 1,2,3,4,5 --first-cell 1.", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_missing_character_on_any_plate_prevents_the_first_one()
    {
        string[] series = [Drawing("glyph"), "--cut", "text", "--csv", _folder.WithFile("glyph.csv", "NAME\nAda\n\uE123\n"), "--json"];
        var plan = await CliRun.RunAsync(["plan", .. series]);
        Assert.Equal(ExitCode.DrawingError, plan.ExitCode);
        Assert.Contains("TXT0005", plan.Error, StringComparison.Ordinal);
        var refused = await CliRun.Typing("\n", ["run", .. series, "--connect", "sim:"]);
        Assert.Equal((ExitCode.DrawingError, "refused"), (refused.ExitCode, Outcome(refused)));
        Assert.Contains("Plate 2 of 2 (glyph=7", refused.Error, StringComparison.Ordinal);
        Assert.Contains("TXT0005", refused.Error, StringComparison.Ordinal);
        Assert.Equal((0, 0), await CounterAsync("glyph"));

        var accepted = await CliRun.Typing("\n", ["run", .. series, "--connect", "sim:", "--accept-errors"]);
        Assert.Equal((ExitCode.DrawingError, "complete"), (accepted.ExitCode, Outcome(accepted)));
        Assert.Equal(2, Plates(accepted).Count);
        Assert.Equal(accepted.Error.IndexOf("TXT0005", StringComparison.Ordinal), accepted.Error.LastIndexOf("TXT0005", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Plan_and_dry_run_show_the_plates_and_spend_nothing()
    {
        var plan = await CliRun.RunAsync("plan", Drawing("planned"), "--cut", "text", "--csv", Csv(), "--rows", "1,3", "--json");
        Assert.True(plan.ExitCode == ExitCode.Done, plan.Error);
        Assert.Equal(["planned=5, csv row 1: NAME=Ada", "planned=7, csv row 3: NAME=Cyd"], Plates(plan).Select(plate => plate.GetProperty("text").GetString()));
        var text = await CliRun.RunAsync("plan", Drawing("planned"), "--cut", "text", "--csv", Csv(), "--rows", "2");
        Assert.Contains("Plate 1 of 1: planned=5, csv row 2: NAME=Bob", text.Out, StringComparison.Ordinal);

        var dry = await CliRun.Typing("\n", [.. Series("planned"), "--rows", "1-2", "--dry-run"]);
        Assert.True(dry.ExitCode == ExitCode.Done, dry.Error);
        Assert.Equal(2, Plates(dry).Count);
        Assert.Equal((0, 0), await CounterAsync("planned"));
    }

    [Fact]
    public async Task A_field_without_a_value_on_any_plate_prevents_the_first_one()
    {
        var csv = _folder.WithFile("holes.csv", "NAME,CITY\nAda,Rome\n,Bern\n");
        var run = await CliRun.Typing("\n", ["run", Drawing("holes"), "--cut", "text", "--csv", csv, "--connect", "sim:", "--json", "--accept-errors"]);

        Assert.Equal((ExitCode.DrawingError, "refused"), (run.ExitCode, Outcome(run)));
        Assert.Contains("SER0002", run.Error, StringComparison.Ordinal);
        Assert.Contains("row 2", run.Error, StringComparison.Ordinal);
        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync("run", Drawing("holes"), "--cut", "text", "--connect", "sim:", "--accept-errors")).ExitCode); // without a CSV file
        Assert.Equal((0, 0), await CounterAsync("holes"));
    }

    [Fact]
    public async Task A_program_is_posted_verified_and_certified_with_the_values_of_its_plate()
    {
        var (drawing, program) = (Drawing("posted"), _folder.PathOf("plate.ngc"));
        var plan = await CliRun.RunAsync("plan", drawing, "--cut", "text", "--csv", Csv(), "--rows", "2", "--json");
        var values = _folder.WithFile("plate.json", Plates(plan)[0].GetProperty("values").GetRawText());
        string[] with = ["--cut", "text", "--values", values];

        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync("post", drawing, "--target", "gcode", "--cut", "text")).ExitCode);
        var posted = await CliRun.RunAsync(["post", drawing, "--target", "gcode", "-o", program, .. with]);
        Assert.True(posted.ExitCode == ExitCode.Done, posted.Error);
        var verified = await CliRun.RunAsync(["verify", program, "--against", drawing, .. with]);
        Assert.True(verified.ExitCode == ExitCode.Done, verified.Error);
        var other = _folder.WithFile("other.json", (await File.ReadAllTextAsync(values)).Replace("Bob", "Bub", StringComparison.Ordinal));
        Assert.Equal(ExitCode.DrawingError, (await CliRun.RunAsync("verify", program, "--against", drawing, "--cut", "text", "--values", other)).ExitCode);
        var certified = await CliRun.RunAsync(["certify", drawing, "--target", "gcode", "--json", .. with]);
        Assert.Equal("posted=5, csv row 2: NAME=Bob", JsonText.Of(certified).GetProperty("plate").GetString());
        Assert.Equal(ExitCode.Done, (await CliRun.RunAsync(["certify", drawing, "--target", "gcode", "--check", .. with])).ExitCode);
        foreach (var file in (string[])[drawing, _folder.WithFile("empty.json", "{}"), _folder.WithFile("plan.json", plan.Out), _folder.WithFile("plates.json", Plates(plan)[0].GetRawText())])
        {
            var refused = await CliRun.RunAsync("verify", program, "--against", drawing, "--values", file);
            Assert.Equal(ExitCode.Usage, refused.ExitCode);
            Assert.Contains("is not a values file", refused.Error, StringComparison.Ordinal);
        }

        Assert.Equal((0, 0), await CounterAsync("posted"));
    }

    [Fact]
    public async Task Copies_without_a_CSV_file_are_numbered()
    {
        var drawing = _folder.WithFile("copies.dxf", Encoding.UTF8.GetString(Plate("[[copy:00]]/[[n copies:00;start=8]]")));
        var run = await CliRun.Typing("\n", "run", drawing, "--cut", "text", "--copies", "2", "--connect", "sim:", "--json", "--counter", "copies=30");

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        Assert.Equal(["copies=30, copy=1", "copies=31, copy=2"], Plates(run).Select(plate => plate.GetProperty("text").GetString()));
        var back = await CliRun.RunAsync("counters", "--counter", "copies=20");
        Assert.Contains("SER0025", back.Error, StringComparison.Ordinal);
        Assert.Contains("copies: next number 20", back.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--rows requires --csv", "--rows", "2")]
    [InlineData("--grid and --pitch", "--grid", "2x2")]
    [InlineData("--grid", "--grid", "2", "--pitch", "1,1")]
    [InlineData("--pitch", "--grid", "2x2", "--pitch", "1")]
    [InlineData("--first-cell requires --grid", "--copies", "2", "--first-cell", "2")]
    [InlineData("no cell 5, only 1 to 4", "--grid", "2x2", "--pitch", "1,1", "--first-cell", "5")]
    [InlineData("--counter", "--counter", "n=-1")]
    [InlineData("--counter", "--counter", "again", "--counter", "next")]
    [InlineData("--copies", "--copies", "2", "--csv", "x.csv")]
    [InlineData("--journal", "--copies", "2", "--journal", "x")]
    [InlineData("--origin here", "--copies", "2", "--origin", "here")]
    [InlineData("--trajectory", "--copies", "2", "--trajectory")]
    [InlineData("--counter", "--copies", "2", "--counter", "n=1", "--dry-run")]
    public async Task Options_that_do_not_fit_are_usage_errors(string named, params string[] options)
    {
        var run = await CliRun.RunAsync(["run", Drawing("usage"), "--cut", "text", "--connect", "sim:", "--json", .. options]);

        Assert.Equal((ExitCode.Usage, "refused"), (run.ExitCode, Outcome(run)));
        Assert.Contains(named, run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("SER0010", "missing.csv", null)]
    [InlineData("SER0012", "NAME,NAME\n1,2\n", null)]
    [InlineData("SER0018", "NAME\nAda\n", "2-3")]
    [InlineData("SER0018", "NAME\nAda\n", "x")]
    [InlineData("SER0002", "CITY\nRome\n", null)]
    public async Task A_CSV_file_that_does_not_fit_is_refused_before_anything_moves(string id, string content, string? rows)
    {
        var csv = content == "missing.csv" ? content : _folder.WithFile("bad.csv", content);
        var run = await CliRun.RunAsync(["run", Drawing("bad"), "--cut", "text", "--connect", "sim:", "--json", "--csv", csv, .. rows is null ? Array.Empty<string>() : ["--rows", rows]]);

        Assert.Equal((ExitCode.DrawingError, "refused"), (run.ExitCode, Outcome(run)));
        Assert.Contains(id, run.Error, StringComparison.Ordinal);
        var plan = await CliRun.RunAsync(["plan", Drawing("bad"), "--cut", "text", "--csv", csv, .. rows is null ? Array.Empty<string>() : ["--rows", rows]]);
        Assert.Equal(ExitCode.DrawingError, plan.ExitCode);
        Assert.Equal([id], Regex.Matches(plan.Error, "SER00[0-9]+").Select(match => match.Value)); // and nothing that follows from it
    }

    [Fact]
    public async Task Columns_that_are_missing_or_not_used_are_named()
    {
        var missing = await CliRun.RunAsync("plan", Drawing("columns"), "--cut", "text", "--csv", _folder.WithFile("city.csv", "CITY,ZIP\nRome,1\n"));
        Assert.Contains("no column NAME; it has CITY, ZIP", missing.Error, StringComparison.Ordinal);
        var more = await CliRun.RunAsync("plan", Drawing("columns"), "--cut", "text", "--csv", _folder.WithFile("more.csv", "CITY,NAME,ZIP\nRome,Ada,1\n"));
        Assert.Equal(ExitCode.Done, more.ExitCode);
        Assert.Contains("SER0006", more.Error, StringComparison.Ordinal);
        Assert.Contains("CITY, ZIP", more.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_CSV_file_that_no_text_uses_is_refused()
    {
        var drawing = _folder.WithFile("plain.dxf", Encoding.UTF8.GetString(Plate("plain")));
        var run = await CliRun.RunAsync("run", drawing, "--cut", "text", "--connect", "sim:", "--csv", Csv());

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Contains("SER0005", run.Error, StringComparison.Ordinal);
    }

    private static string? Outcome(CliRun run) => JsonText.Of(run).GetProperty("outcome").GetString();

    private static IReadOnlyList<JsonElement> Plates(CliRun run) => [.. JsonText.Of(run).GetProperty("plates").EnumerateArray()];

    /// <summary>The next number (0: no such counter) and the number of plates that are not finished or left out.</summary>
    private static async Task<(long Next, int Plates)> CounterAsync(string name)
    {
        var state = JsonText.Of(await CliRun.RunAsync("counters", "--json"));
        var next = state.GetProperty("counters").EnumerateArray().Where(one => one.GetProperty("name").GetString() == name).Select(one => one.GetProperty("next").GetInt64()).FirstOrDefault();
        return (next, state.GetProperty("plates").EnumerateArray().Count(plate => plate.GetProperty("numbers").TryGetProperty(name, out _)));
    }

    private string[] Series(string counter, string address = "sim:") => ["run", Drawing(counter), "--cut", "text", "--csv", Csv(), "--connect", address, "--json"];

    private string Csv() => _folder.WithFile("names.csv", Names);

    private string Drawing(string counter) => _folder.WithFile("plate.dxf", Encoding.UTF8.GetString(Plate($"[[n {counter}:00;start=5;step=2]] [[csv:NAME]]")));

    /// <summary>A frame of 60 by 20 mm around a text.</summary>
    private static byte[] Plate(string text) => DxfText.WithEntities(
        (0, "LWPOLYLINE"), (8, "0"), (90, 4), (70, 1), (10, 0.0), (20, 0.0), (10, 60.0), (20, 0.0), (10, 60.0), (20, 20.0), (10, 0.0), (20, 20.0),
        (0, "TEXT"), (8, "0"), (10, 5.0), (20, 8.0), (40, 4.0), (1, text)).ToAscii();

    private static async Task<string> AddressAsync(SimulatedController controller)
    {
        var clock = (await controller.ListenClockAsync(CancellationToken.None)).Port;
        var port = (await controller.ListenTcpAsync(0, CancellationToken.None)).Port;
        return string.Create(CultureInfo.InvariantCulture, $"tcp://127.0.0.1:{port}?clock={clock}");
    }

    private static Task<CliRun> InPlateThreeAsync(Action<CancellationTokenSource> interrupt, string[] args) => InterruptedSeries.InPlateThreeAsync("for plate 3", interrupt, args);
}
