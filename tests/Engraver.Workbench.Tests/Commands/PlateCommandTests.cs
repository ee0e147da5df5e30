using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Drawings whose texts have fields, at the command line: the next plate is shown; a start spends its numbers and its end confirms them.</summary>
public sealed class PlateCommandTests
{
    private const string Numbered = "N [[n:000;start=41]]";

    [Fact]
    public async Task The_next_plate_is_what_is_prepared_and_shown_and_nothing_is_spent()
    {
        await using var talk = await OpenAsync(Numbered);
        var derived = await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None);

        Assert.Equal("n=41", derived.Plate!.ToString());
        Assert.True(derived.Job!.IsOf(talk.State, derived.Plate));
        Assert.Equal(await LengthAsync("N 041"), derived.Job.Sequence.PathLength, precision: 9);
        Assert.Equal("N 041", ShownDrawing.ValuesOf(talk.State.Drawing!).Fill(Numbered, ""));
        Assert.Empty(talk.Session.Plates.Book.Read().Counters);

        await talk.TypeAsync("CNCPLATE", "cOunter", "7");
        Assert.False(derived.Job.IsOf(talk.State, talk.Session.Plates.Of(talk.State)));
        Assert.Equal(await LengthAsync("N 007"), (await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None)).Job!.Sequence.PathLength, precision: 9);
        Assert.Contains("Plate 1: n=7", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCTEXT", "No");
        Assert.Equal(PlateValues.None, ShownDrawing.ValuesOf(talk.State.Drawing!));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCPLATE", "Status"));
    }

    [Fact]
    public async Task A_start_spends_the_number_and_the_end_confirms_it()
    {
        await using var talk = await OpenAsync(Numbered);
        CounterState? during = null;
        talk.Session.Machine.Changed += (_, _) => during ??= talk.Session.Machine.Runs.Progress is { SegmentsExecuted: > 0 } ? talk.Session.Plates.Book.Read() : null;

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));

        Assert.Equal(41, Assert.Single(during!.Plates).Numbers["n"]);
        Assert.Equal((42L, 0), NextAndOpen(talk));
        Assert.Equal("n=42", talk.Session.Plates.Of(talk.State)!.ToString());
        Assert.Equal("n=41", Assert.Single(talk.Session.History.Snapshot.Entries).Plate);

        await talk.TypeAsync("CNCARM", "Stream");
        Assert.Equal("n=42", talk.Session.Machine.Arming.Armed!.Job.Plate!.ToString());
        Assert.Contains("Plate 2: n=42", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));
        Assert.Equal((43L, 0), NextAndOpen(talk));
    }

    [Theory]
    [InlineData("CNCRUN", "Dryrun", "Yes")]
    [InlineData("CNCSIM")]
    public async Task A_run_that_engraves_nothing_spends_nothing(params string[] inputs)
    {
        await using var talk = await OpenAsync(Numbered);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync(inputs));

        Assert.Equal(JobOutcome.Complete, talk.Session.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Empty(talk.Session.Plates.Book.Read().Counters);
    }

    [Theory]
    [InlineData("Again", 41)]
    [InlineData("Next", 42)]
    public async Task After_a_plate_that_is_not_finished_a_start_asks_for_its_number(string answer, long number)
    {
        await using var talk = await OpenAsync(Numbered);
        await StopAsync(talk);
        Assert.Equal((42L, 1), NextAndOpen(talk));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Contains("SER0022", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("Cancel"));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCARM", "Stream"));

        Assert.IsType<InputResult.Done>(await talk.TypeAsync(answer));
        Assert.Equal(number, talk.Session.Machine.Arming.Armed!.Job.Plate!.Values.Counters["n"]);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));

        Assert.Equal((number + 1, 0), (NextAndOpen(talk).Next, talk.Session.Plates.Book.Read().Plates.Count(plate => !plate.IsLeftOut)));
    }

    [Fact]
    public async Task A_resumed_plate_has_the_values_of_its_journal_and_is_confirmed()
    {
        await using var talk = await OpenAsync(Numbered);
        await StopAsync(talk);
        await talk.TypeAsync("CNCPLATE", "cOunter", "60");
        Assert.Equal("n=60", talk.Session.Plates.Of(talk.State)!.ToString());

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRESUME", ""));
        Assert.Equal("n=41", talk.Session.Plates.Of(talk.State)!.ToString());
        Assert.Equal("N 041", ShownDrawing.ValuesOf(talk.State.Drawing!).Fill(Numbered, ""));
        await talk.TypeAsync("CNCARM", "");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));

        Assert.NotNull(talk.Session.Machine.Runs.LastRun!.ResumedFrom);
        Assert.Equal((60L, 0), NextAndOpen(talk));
        Assert.Equal("n=60", talk.Session.Plates.Of(talk.State)!.ToString());
    }

    [Fact]
    public async Task The_rows_of_a_CSV_file_are_engraved_up_to_the_last_one()
    {
        await using var talk = await OpenAsync("[[csv:NAME]] [[copy]]");
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN")); // no values
        await File.WriteAllTextAsync(talk.PathOf("names.csv"), "NAME\nAda\nBob\nCy\n");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCPLATE", "Csv", "names.csv"));
        Assert.Contains("Plate 3 of 3: copy=3, csv row 3: NAME=Cy", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCPLATE", "Row", "2");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Equal(3, talk.Session.Plates.Number);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Equal(["copy=2, csv row 2: NAME=Bob", "copy=3, csv row 3: NAME=Cy"], talk.Session.History.Snapshot.Entries.Select(entry => entry.Plate).Order(StringComparer.Ordinal));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN"));
        Assert.Contains("All 3 rows of names.csv are engraved.", talk.Said, StringComparison.Ordinal);

        await talk.TypeAsync("CNCPLATE", "Row", "1");
        Assert.Equal("Ada 1", ShownDrawing.ValuesOf(talk.State.Drawing!).Fill("[[csv:NAME]] [[copy]]", ""));
        await talk.TypeAsync("CNCPLATE", "None");
        Assert.Null(talk.Session.Plates.Csv);
    }

    [Theory]
    [InlineData("A,A\n1,2\n", "SER0012")]
    [InlineData("OTHER\nx\n", "SER0005")]
    public async Task A_CSV_file_that_does_not_fit_is_not_used(string content, string rule)
    {
        await using var talk = await OpenAsync(Numbered);
        await File.WriteAllTextAsync(talk.PathOf("names.csv"), content);

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCPLATE", "Csv", "names.csv"));

        Assert.Contains(rule, talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.Plates.Csv);
    }

    [Fact]
    public async Task Damaged_counters_start_nothing()
    {
        await using var talk = await OpenAsync(Numbered);
        Directory.CreateDirectory(talk.PathOf("counters"));
        await File.WriteAllTextAsync(talk.PathOf("counters/counters.json"), "{");

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN"));

        Assert.Contains("SER0020", talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.Machine.Runs.LastRun);
    }

    private static (long Next, int Open) NextAndOpen(CommandTestSession talk) => talk.Session.Plates.Book.Read() is var state ? (state.Counters.Single().Next, state.Plates.Count(plate => !plate.IsLeftOut)) : default;

    private static async Task StopAsync(CommandTestSession talk)
    {
        var stopped = false;
        void Stop(object? sender, EventArgs e)
        {
            if (stopped || talk.Session.Machine is not { IsRunning: true, Runs.Progress.SegmentsExecuted: > 3 }) return;
            stopped = true;
            talk.Session.Machine.Controls.Stop();
        }

        talk.Session.Machine.Changed += Stop;
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Yes"));
        talk.Session.Machine.Changed -= Stop;
        Assert.Equal(JobOutcome.Stopped, talk.Session.Machine.Runs.LastRun!.Result.Outcome);
    }

    private static async Task<double> LengthAsync(string text)
    {
        await using var talk = await OpenAsync(text);
        return (await talk.Session.Derivation.ForCurrentAsync(CancellationToken.None)).Job!.Sequence.PathLength;
    }

    /// <summary>A drawing of one text, connected to a simulated controller.</summary>
    private static async Task<CommandTestSession> OpenAsync(string text)
    {
        var talk = new CommandTestSession();
        await File.WriteAllBytesAsync(talk.PathOf("plate.dxf"), DxfText.WithEntities((0, "TEXT"), (8, "0"), (5, "A2"), (10, 0.0), (20, 5.0), (40, 5.0), (1, text)).ToAscii());
        await talk.TypeAsync("OPEN", "plate.dxf", "CNCTEXT", "Yes", "CNCCONNECT", "sim:");
        return talk;
    }
}
