using Engraver.Core.Diagnostics;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The counters of the operator, which every program on this computer shares. A number is spent before the first motion of its plate and confirmed
/// at the end of the plate; between the two a new plate of this counter needs a decision (<see cref="CounterChoice"/>).</summary>
public sealed class CounterBook
{
    /// <summary>Plates that were left out and are kept for a late resume.</summary>
    private const int MaxLeftOut = 200;

    private readonly string _path;
    private readonly TimeProvider _time;
    private readonly CounterFile _file;

    /// <param name="path">The file; it need not exist.</param>
    public CounterBook(string path, TimeProvider time) => (_path, _time, _file) = (path, time, new CounterFile(path, time));

    /// <summary>The book in the operator's data folder.</summary>
    public static CounterBook OfOperator(TimeProvider time) => In(null, time);

    /// <summary>The book beside journals.</summary>
    /// <param name="journals">Their folder; null for the operator's data folder.</param>
    public static CounterBook In(string? journals, TimeProvider time) => new(UserFiles.CountersIn(journals ?? UserFiles.Folder), time);

    /// <exception cref="CounterException">The file cannot be read, or is damaged.</exception>
    public CounterState Read()
    {
        var document = _file.Read();
        return new CounterState(document.Counters, document.Plates);
    }

    /// <summary>The numbers of the next plates; changes nothing.</summary>
    /// <param name="plates">How many.</param>
    /// <exception cref="CounterException">The file cannot be read or is damaged, or a counter has no further number.</exception>
    public CounterForecast Forecast(IReadOnlyList<CounterDesign> designs, CounterChoice choice, int plates)
    {
        ArgumentNullException.ThrowIfNull(designs);
        return Forecast(_file.Read(), designs, choice, plates);
    }

    /// <summary>Sets the next number of a counter. Its unfinished plates are left out.</summary>
    /// <returns>A warning if the number is below the next one: numbers will be engraved twice.</returns>
    /// <exception cref="CounterException">The file cannot be read or written, or is damaged.</exception>
    public async Task<Diagnostic?> SetAsync(string counter, long next, CancellationToken cancellation)
    {
        Diagnostic? warning = null;
        await _file.ChangeAsync(
            document =>
            {
                if (document.NextOf(counter) is { } before && next < before) warning = SerialRules.CounterSetBack.At(default, counter, FactText.Of(before), FactText.Of(next));
                return LeaveOut(document, [counter]).WithNext(counter, next);
            },
            cancellation).ConfigureAwait(false);
        return warning;
    }

    /// <summary>Spends the numbers of a plate: they are on the disk when this returns.</summary>
    /// <param name="values">With the numbers of <see cref="Forecast(IReadOnlyList{CounterDesign}, CounterChoice, int)"/>.</param>
    /// <param name="drawing">Its file.</param>
    /// <param name="journal">The journal of its run.</param>
    /// <exception cref="CounterException">An unfinished plate needs a decision; another process has taken the number; the file cannot be read or written, or
    /// is damaged.</exception>
    public async Task<SpentPlate> SpendAsync(IReadOnlyList<CounterDesign> designs, PlateValues values, CounterChoice choice, string drawing, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(designs);
        ArgumentNullException.ThrowIfNull(values);
        if (values.Counters.IsEmpty) return SpentPlate.WithoutNumbers;
        var plate = NewPlate(values, drawing, journal);
        var live = LivePlate.Hold(_path, plate.Id);
        try
        {
            var fresh = new List<(string Counter, long Number, long Next)>();
            await _file.ChangeAsync(document => Spend(document, designs, choice, plate, fresh), cancellation).ConfigureAwait(false);
            return new SpentPlate(_file, plate, fresh, live);
        }
        catch
        {
            live.Dispose();
            throw;
        }
    }

    /// <summary>Takes the numbers of an interrupted plate for its continuation.</summary>
    /// <param name="values">Those of the interrupted run.</param>
    /// <param name="choice"><see cref="CounterChoice.Again"/>: also numbers that the book does not know as started.</param>
    /// <param name="journal">The journal of the continuation.</param>
    /// <exception cref="CounterException">A number is not that of an unfinished plate, or that plate is being engraved now; the file cannot be read or written,
    /// or is damaged.</exception>
    public async Task<SpentPlate> ResumeAsync(PlateValues values, CounterChoice choice, string drawing, string journal, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(values);
        if (values.Counters.IsEmpty) return SpentPlate.WithoutNumbers;
        var plate = NewPlate(values, drawing, journal);
        var live = LivePlate.Hold(_path, plate.Id);
        try
        {
            await _file.ChangeAsync(document => Resume(document, plate, choice), cancellation).ConfigureAwait(false);
            return new SpentPlate(_file, plate, [], live);
        }
        catch
        {
            live.Dispose();
            throw;
        }
    }

    private StartedPlate NewPlate(PlateValues values, string drawing, string journal) => new()
    {
        Id = Guid.NewGuid().ToString("N")[..12],
        Numbers = values.Counters.ToDictionary(),
        Values = values.ToString(),
        Drawing = Path.GetFullPath(drawing),
        Journal = Path.GetFullPath(journal),
        Date = _time.GetUtcNow(),
    };

    private CounterForecast Forecast(CounterDocument document, IReadOnlyList<CounterDesign> designs, CounterChoice choice, int plates)
    {
        var unfinished = Unfinished(document, [.. designs.Select(one => one.Name)]).ToList();
        var numbers = designs.ToDictionary(one => one.Name, one => NumbersOf(document, one, choice == CounterChoice.Again ? unfinished : []).Take(plates).ToList());
        return new CounterForecast(
            [.. Enumerable.Range(0, plates).Select(plate => numbers.ToDictionary(one => one.Key, one => one.Value[plate]))],
            choice == CounterChoice.Ask && unfinished.Count > 0 ? NotFinished(unfinished[0]) : null);
    }

    private static Diagnostic NotFinished(StartedPlate plate) =>
        SerialRules.PlateNotFinished.At(default, plate.Values, plate.Drawing, FormattableString.Invariant($"{plate.Date.ToLocalTime():yyyy-MM-dd HH:mm}"), plate.Journal);

    /// <summary>Those of unfinished plates, the oldest first, then the next ones.</summary>
    private static IEnumerable<long> NumbersOf(CounterDocument document, CounterDesign design, IReadOnlyList<StartedPlate> again)
    {
        foreach (var plate in again)
        {
            foreach (var (_, number) in plate.Numbers.Where(one => CounterDocument.IsSame(one.Key, design.Name))) yield return number;
        }

        for (var next = document.NextOf(design.Name) ?? design.Start; ; next += design.Increment)
        {
            if (next is < 0 or > SerialFieldReader.MaxNumber) throw new CounterException(SerialRules.CounterExhausted.At(default, design.Name, FactText.Of(next)));
            yield return next;
        }
    }

    /// <summary>Plates with one of the counters that no process is engraving now and that were not left out.</summary>
    private IEnumerable<StartedPlate> Unfinished(CounterDocument document, IReadOnlyList<string> counters) =>
        document.Plates.Where(plate => !plate.IsLeftOut && plate.Numbers.Keys.Any(name => counters.Any(one => CounterDocument.IsSame(one, name))) && !LivePlate.IsHeld(_path, plate.Id));

    private CounterDocument LeaveOut(CounterDocument document, IReadOnlyList<string> counters)
    {
        var left = Unfinished(document, counters).Select(plate => plate.Id).ToHashSet();
        StartedPlate[] plates = [.. document.Plates.Select(plate => left.Contains(plate.Id) ? plate with { IsLeftOut = true } : plate)];
        var kept = plates.Where(plate => plate.IsLeftOut).TakeLast(MaxLeftOut).ToHashSet();
        return document with { Plates = [.. plates.Where(plate => !plate.IsLeftOut || kept.Contains(plate))] };
    }

    private CounterDocument Spend(CounterDocument document, IReadOnlyList<CounterDesign> designs, CounterChoice choice, StartedPlate plate, List<(string Counter, long Number, long Next)> fresh)
    {
        var forecast = Forecast(document, designs, choice, 1);
        if (forecast.Refusal is { } refusal) throw new CounterException(refusal);
        if (choice == CounterChoice.Next) document = LeaveOut(document, [.. designs.Select(one => one.Name)]);
        foreach (var design in designs)
        {
            var (next, number) = (forecast.Plates[0][design.Name], plate.Numbers.First(one => CounterDocument.IsSame(one.Key, design.Name)).Value);
            if (next != number) throw new CounterException(SerialRules.CounterMoved.At(default, design.Name, FactText.Of(number), FactText.Of(next)));
            if (choice == CounterChoice.Again && document.Plates.Any(one => one.Has(design.Name, number)))
            {
                document = document.Without(design.Name, number);
                continue;
            }

            fresh.Add((design.Name, number, number + design.Increment));
            document = document.WithNext(design.Name, number + design.Increment);
        }

        return document with { Plates = [.. document.Plates, plate] };
    }

    private CounterDocument Resume(CounterDocument document, StartedPlate plate, CounterChoice choice)
    {
        foreach (var (counter, number) in plate.Numbers)
        {
            var isOpen = document.Plates.Any(one => one.Has(counter, number) && !LivePlate.IsHeld(_path, one.Id));
            if (!isOpen && choice != CounterChoice.Again) throw new CounterException(SerialRules.NumberNotOpen.At(default, counter, FactText.Of(number)));
            if (isOpen) document = document.Without(counter, number);
        }

        return document with { Plates = [.. document.Plates, plate] };
    }
}
