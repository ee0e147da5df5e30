using System.CommandLine;
using Engraver.Cli.Options;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Cli.Verbs.Plates;

/// <summary>The plates of a run with their values, before the first of them starts.</summary>
internal sealed class SeriesPlan
{
    private readonly SeriesOptions _options;
    private readonly CounterBook _book;
    private readonly CounterChoice _choice;
    private readonly Plate? _resumed;
    private readonly bool _isDryRun;
    private readonly IReadOnlyList<Plate> _plates;

    /// <summary>How many plates get the numbers of unfinished ones. A plate that another program leaves unfinished later needs its own decision.</summary>
    private readonly int _again;

    private SeriesPlan(SeriesOptions options, PlateSeries series, CounterBook book, CounterChoice choice, Plate? resumed, bool isDryRun, IReadOnlyList<Plate> plates, int again) =>
        (_options, Series, _book, _choice, _resumed, _isDryRun, _plates, _again) = (options, series, book, choice, resumed, isDryRun, plates, again);

    public PlateSeries Series { get; }

    /// <summary>Index of the first plate to run: 0, or that of the resumed or repeated plate.</summary>
    public int First => _plates[0].Number - 1;

    public int End => First + Count;

    /// <summary>Number of plates to run.</summary>
    public int Count => _plates.Count;

    /// <summary>The plates to run.</summary>
    public IReadOnlyList<Plate> Plates => _plates;

    /// <summary>Fields without a value.</summary>
    public IReadOnlyList<Diagnostic> Findings => [.. Series.Check(_plates).Where(finding => finding.Severity == Severity.Error)];

    /// <summary>Reads the options, the CSV file and the counters. Sets the counters that the options name.</summary>
    /// <param name="fields">Those of the drawing.</param>
    /// <param name="isDryRun">Nothing is spent, and no decision about an unfinished plate is needed.</param>
    /// <param name="resumed">Journal of an interrupted plate; null for none.</param>
    /// <returns>No plan where a finding is an error.</returns>
    /// <exception cref="UsageException">Options that cannot be used together.</exception>
    /// <exception cref="CounterException">The counters give no number, or an unfinished plate needs a decision, or its row is not in the series.</exception>
    public static async Task<(SeriesPlan? Plan, IReadOnlyList<Diagnostic> Findings)> ReadAsync(ParseResult parsed, SeriesOptions options, Drawing drawing, PlateFields fields, bool isDryRun, string? resumed, CancellationToken stop)
    {
        var (series, findings) = options.Read(parsed, fields, drawing.Placement);
        if (series is null) return (null, findings);
        var (book, request, isSeries) = (CounterBook.OfOperator(TimeProvider.System), options.Counter(parsed), options.Requested(parsed) is not null);
        if (isDryRun && request.Values.Count > 0) throw new UsageException(Wording.Get("Series.SetsNothing"));
        var interrupted = resumed is null ? null : Interrupted(resumed, series, isSeries);
        foreach (var (counter, value) in request.Values)
        {
            if (await book.SetAsync(counter, value, stop).ConfigureAwait(false) is { } warning) findings = [.. findings, warning];
        }

        var now = TimeProvider.System.GetLocalNow();
        if (interrupted is not null)
        {
            var rest = isSeries ? series.Count - interrupted.Number : 0;
            var next = book.Forecast(fields.Counters, CounterChoice.Next, rest);
            return (new SeriesPlan(options, series, book, request.Choice, interrupted, isDryRun, [interrupted, .. Enumerable.Range(0, rest).Select(i => series.At(interrupted.Number + i, next.Plates[i], now))], again: 1), findings);
        }

        var unfinished = request.Choice == CounterChoice.Ask ? [] : book.Unfinished(fields.Counters);
        var first = series.Rows[0] is not null ? series.FirstAfter(unfinished, request.Choice, drawing.FileName, options.HasRows(parsed)) : isSeries ? FirstCopy(series, unfinished, drawing.FileName) : 0;
        var count = series.Count - first;
        var forecast = book.Forecast(fields.Counters, request.Choice, count);
        if (forecast.Refusal is { } refusal && !isDryRun) throw new CounterException(refusal);
        return (new SeriesPlan(options, series, book, request.Choice, null, isDryRun, [.. Enumerable.Range(0, count).Select(i => series.At(first + i, forecast.Plates[i], now))], unfinished.Count), findings);
    }

    /// <summary>The list of the plates, if there are several, and where a series is continued.</summary>
    public void Write(TextWriter output)
    {
        if (First > 0 && _resumed is null) output.WriteLine(Wording.Get("Series.Continues", First + 1, Series.Count));
        foreach (var plate in _plates) output.WriteLine(Wording.Get("Series.Plate", plate.Number, Series.Count, plate));
    }

    /// <summary>Makes the letters of every plate, and reports the errors in them with their plate: each finding once.</summary>
    /// <returns>The errors. None for a single plate, whose job reports them.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    public async Task<IReadOnlyList<Diagnostic>> ReportLettersAsync(VerbHost host, ParseResult parsed, Drawing drawing, DrawingSettings settings, CancellationToken stop)
    {
        if (Count == 1) return [];
        var errors = await StoppableVerb.ComputeAsync(() => LetterErrors(drawing, settings, stop), stop).ConfigureAwait(false);
        foreach (var (plate, found) in errors)
        {
            await host.Error.WriteLineAsync(Wording.Get("Series.PlateErrors", plate.Number, Series.Count, plate)).ConfigureAwait(false);
            host.Report(parsed, drawing.FileName, found);
        }

        return [.. errors.SelectMany(one => one.Found)];
    }

    /// <summary>The plates after the first one: their work origins, and what they reach there.</summary>
    /// <returns>Null for a single plate.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    public FollowingJobs? Following(Drawing drawing, DrawingSettings settings, MotionStyle style, CancellationToken stop)
    {
        var own = _plates[0].Fixture;
        return Count == 1 ? null : new FollowingJobs(
            Reached(_plates.Skip(1).Where(plate => plate.Fixture == own), drawing, settings, style, stop),
            [.. _plates.Where(plate => plate.Fixture is not null && plate.Fixture != own).GroupBy(plate => plate.Fixture!, (name, there) => (name, Reached(there, drawing, settings, style, stop)))]);
    }

    /// <returns>Null for no plate, and for a machine without travel limits, where it does not matter.</returns>
    private static MotionExtents? Reached(IEnumerable<Plate> plates, Drawing drawing, DrawingSettings settings, MotionStyle style, CancellationToken stop)
    {
        if (TravelLimits.Of(settings.Machine).Count == 0) return null;
        MotionExtents? all = null;
        foreach (var plate in plates)
        {
            if (PlateJob.Prepare(drawing, settings, style, plate, stop).Motion.Program is not { } program) continue;
            var reached = MotionExtents.Of(program);
            all = all?.Union(reached) ?? reached;
        }

        return all;
    }

    /// <summary>The run of a plate, with the present date and the numbers of this moment: another program may have taken some since.</summary>
    /// <exception cref="CounterException">The counters cannot be read, or are damaged, or an unfinished plate is no longer the one of the plan.</exception>
    public PlateTurn Turn(int index)
    {
        var isResumed = _resumed is not null && index == First;
        var isAgain = _choice == CounterChoice.Again && index - First < _again;
        var choice = _choice == CounterChoice.Again && !isAgain ? CounterChoice.Ask : _choice;
        var plate = isResumed ? _resumed! : _isDryRun ? _plates[index - First] : Series.At(index, _book.Forecast(Series.Fields.Counters, choice, 1).Plates[0], TimeProvider.System.GetLocalNow());
        if (isAgain)
        {
            foreach (var (counter, number) in _plates[index - First].Values.Counters.Where(one => plate.Values.Counters[one.Key] != one.Value)) throw new CounterException(SerialRules.CounterMoved.At(default, counter, FactText.Of(number), FactText.Of(plate.Values.Counters[counter])));
        }

        return new PlateTurn(plate, Series.Fields.Counters, _isDryRun ? null : _book, choice, isResumed);
    }

    /// <summary>Waits for Enter. The end of the input ends the series.</summary>
    /// <returns>False if there is no input.</returns>
    /// <exception cref="OperationCanceledException">The operator stopped.</exception>
    public async Task<bool> AskForBlankAsync(VerbHost host, int index, CancellationToken stop)
    {
        host.Error.WriteLine(Wording.Get("Series.PlaceBlank", index + 1, Series.Count, _plates[index - First]));
        try
        {
            if (await host.ReadLineAsync(stop).ConfigureAwait(false) is not null) return true;
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

    private string StoppedText(int index) => Wording.Get("Series.Stopped", index + 1, Series.Count, _options.Continuing(Series, index));

    private List<(Plate Plate, IReadOnlyList<Diagnostic> Found)> LetterErrors(Drawing drawing, DrawingSettings settings, CancellationToken stop)
    {
        var (errors, known) = (new List<(Plate, IReadOnlyList<Diagnostic>)>(), new HashSet<(SourceRef, string)>());
        foreach (var plate in _plates)
        {
            stop.ThrowIfCancellationRequested();
            var letters = JobPreparation.To<LetteredJob>(drawing, settings, plate.Values).Letters;
            List<Diagnostic> found = [.. letters.Findings.Concat(letters.Faults).Where(finding => finding.Severity == Severity.Error && known.Add((finding.Source, finding.Message)))];
            if (found.Count > 0) errors.Add((plate, found));
        }

        return errors;
    }

    /// <summary>Without a CSV file: the index of the unfinished plate, if its journal shows that it was started in this place of this drawing.</summary>
    private static int FirstCopy(PlateSeries series, IReadOnlyList<StartedPlate> unfinished, string drawing)
    {
        if (unfinished.Count == 0 || !unfinished[0].IsOf(drawing) || JournalPlate.Read(unfinished[0].Journal) is not { } plate) return 0;
        return plate.Values.Row is null && series.IsPlaceOf(plate, plate.Number - 1) ? plate.Number - 1 : 0;
    }

    private static Plate Interrupted(string journal, PlateSeries series, bool isSeries)
    {
        if (JournalPlate.Read(journal) is not { } plate) throw new UsageException(Wording.Get("Series.JournalWithoutPlate", journal));
        if (!isSeries) return plate;
        var row = plate.Number <= series.Count ? series.Rows[plate.Number - 1] : null;
        var isThere = series.IsPlaceOf(plate, plate.Number - 1) && (row is null ? plate.Values.Row is null : series.Fields.Used(row) == plate.Values.Row);
        return isThere ? plate : throw new UsageException(Wording.Get("Series.OtherPlate", journal, plate));
    }
}
