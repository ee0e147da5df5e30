using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.Diagnostics;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Verbs.Plates;

/// <summary>The plates of a run with their values, before the first of them starts.</summary>
internal sealed class SeriesPlan
{
    private readonly CounterBook _book;
    private readonly CounterChoice _choice;
    private readonly Plate? _resumed;
    private readonly bool _isDryRun;
    private readonly IReadOnlyList<Plate> _plates;

    private SeriesPlan(PlateSeries series, CounterBook book, CounterChoice choice, Plate? resumed, bool isDryRun, IReadOnlyList<Plate> plates) =>
        (Series, _book, _choice, _resumed, _isDryRun, _plates) = (series, book, choice, resumed, isDryRun, plates);

    public PlateSeries Series { get; }

    /// <summary>Index of the first plate to run: 0, or that of the resumed plate.</summary>
    public int First => _plates[0].Number - 1;

    public int End => First + Count;

    /// <summary>Number of plates to run.</summary>
    public int Count => _plates.Count;

    /// <summary>The plates to run.</summary>
    public IReadOnlyList<Plate> Plates => _plates;

    /// <summary>Fields without a value.</summary>
    public IReadOnlyList<Diagnostic> Findings => [.. Series.Check(_plates).Where(finding => finding.Severity == Severity.Error)];

    /// <summary>Reads the options, the CSV file and the counters. Sets the counters that the options name.</summary>
    /// <param name="isDryRun">Nothing is spent, and no decision about an unfinished plate is needed.</param>
    /// <param name="resumed">Journal of an interrupted plate; null for none.</param>
    /// <returns>No plan where a finding is an error.</returns>
    /// <exception cref="UsageException">Options that cannot be used together.</exception>
    /// <exception cref="CounterException">The counters give no number, or an unfinished plate needs a decision.</exception>
    public static async Task<(SeriesPlan? Plan, IReadOnlyList<Diagnostic> Findings)> ReadAsync(VerbHost host, ParseResult parsed, SeriesOptions options, PlateFields fields, bool isDryRun, string? resumed, CancellationToken stop)
    {
        var (series, findings) = options.Read(parsed, fields);
        if (series is null) return (null, findings);
        var (book, request) = (CounterBook.OfOperator(TimeProvider.System), options.Counter(parsed));
        if (isDryRun && request.Values.Count > 0) throw new UsageException(Wording.Get("Series.SetsNothing"));
        var interrupted = resumed is null ? null : Interrupted(resumed, series, options.Requested(parsed) is not null);
        foreach (var (counter, value) in request.Values)
        {
            if (await book.SetAsync(counter, value, stop).ConfigureAwait(false) is { } warning) findings = [.. findings, warning];
        }

        var first = interrupted is null ? 0 : interrupted.Number - 1;
        var count = interrupted is not null && options.Requested(parsed) is null ? 1 : series.Count - first;
        var forecast = book.Forecast(fields.Counters, interrupted is null ? request.Choice : CounterChoice.Next, count);
        if (forecast.Refusal is { } refusal && !isDryRun) throw new CounterException(refusal);
        var now = TimeProvider.System.GetLocalNow();
        IReadOnlyList<Plate> fresh = [.. Enumerable.Range(0, interrupted is null ? count : count - 1).Select(i => series.At(first + i + (interrupted is null ? 0 : 1), forecast.Plates[i], now))];
        return (new SeriesPlan(series, book, request.Choice, interrupted, isDryRun, interrupted is null ? fresh : [interrupted, .. fresh]), findings);
    }

    /// <summary>The list of the plates.</summary>
    public void Write(TextWriter output)
    {
        foreach (var plate in _plates) output.WriteLine(Wording.Get("Series.Plate", plate.Number, Series.Count, plate));
    }

    /// <summary>The run of a plate, with the present date and the numbers of this moment: another program may have taken some since.</summary>
    /// <exception cref="CounterException">The counters cannot be read, or are damaged.</exception>
    public PlateTurn Turn(int index)
    {
        var isResumed = _resumed is not null && index == First;
        var plate = isResumed ? _resumed! : _isDryRun ? _plates[index - First] : Series.At(index, _book.Forecast(Series.Fields.Counters, _choice, 1).Plates[0], TimeProvider.System.GetLocalNow());
        return new PlateTurn(plate, Series.Fields.Counters, _isDryRun ? null : _book, _choice, isResumed);
    }

    /// <summary>Waits for Enter. The end of the input ends the series.</summary>
    /// <returns>False if there is no input.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    public async Task<bool> AskForBlankAsync(VerbHost host, int index, CancellationToken stop)
    {
        host.Error.WriteLine(Wording.Get("Series.PlaceBlank", index + 1, Series.Count, _plates[index - First]));
        try
        {
            if (await Task.Run(host.In.ReadLine, stop).WaitAsync(stop).ConfigureAwait(false) is not null) return true; // A console read cannot be cancelled: the operator's stop does not wait for it.
        }
        catch (OperationCanceledException)
        {
            host.Error.WriteLine(StoppedText(index));
            throw;
        }

        host.Error.WriteLine(StoppedText(index));
        return false;
    }

    /// <summary>What to do after a plate that is not complete; null for a single plate that was not started.</summary>
    /// <param name="journal">Of its run; null if it was not started.</param>
    public string? InterruptedText(int index, string? journal)
    {
        if (Series.Count == 1) return journal is null ? null : Wording.Get("Series.InterruptedAlone", journal);
        return journal is null ? StoppedText(index) : Wording.Get("Series.Interrupted", index + 1, Series.Count, journal);
    }

    private string StoppedText(int index) => Series.Rows[index] is null ? Wording.Get("Series.Stopped", index + 1, Series.Count)
        : Wording.Get("Series.StoppedBeforeRow", index + 1, Series.Count, string.Join(',', Series.Rows.Skip(index).Select(row => row!.Number)));

    private static Plate Interrupted(string journal, PlateSeries series, bool isSeries)
    {
        if (JournalPlate.Read(journal) is not { } plate) throw new UsageException(Wording.Get("Series.JournalWithoutPlate", journal));
        if (!isSeries) return plate;
        var row = plate.Number <= series.Count ? series.Rows[plate.Number - 1] : null;
        if (plate.Number > series.Count || (row is null ? plate.Values.Row is not null : series.Fields.Used(row) != plate.Values.Row)) throw new UsageException(Wording.Get("Series.OtherPlate", journal, plate));
        return plate;
    }
}
