using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>The plates of the open drawing, if texts with fields are cut: the next one with its values, and the CSV file from which they come. It does not
/// belong to the undo history: a plate that was engraved remains engraved.</summary>
/// <remarks>Any thread.</remarks>
public sealed class PlateSession(CounterBook book, TimeProvider time)
{
    private readonly Lock _guard = new();
    private (Drawing Drawing, DrawingSettings Settings)? _of;
    private string? _fileName;
    private NextPlate _next = NextPlate.None;
    private Plate? _resumed;

    /// <summary>Raised after the next plate has changed.</summary>
    public event EventHandler? Changed;

    /// <summary>The counters of the operator.</summary>
    public CounterBook Book => book;

    /// <summary>Null for none.</summary>
    public PlateCsv? Csv { get; private set; }

    /// <summary>Number of the next plate, from 1: with a CSV file that of its row, otherwise what <c>[[copy]]</c> stands for.</summary>
    public int Number { get; private set; } = 1;

    /// <summary>Which number the next plate gets after one that was not finished. Valid for one plate.</summary>
    public CounterChoice Choice { get; private set; }

    /// <summary>The interrupted plate that is engraved next; null for a new one.</summary>
    public Plate? Resumed
    {
        get => _resumed;
        set
        {
            if (_resumed == value) return;
            _resumed = value;
            RaiseChanged();
        }
    }

    /// <summary>The next plate of a document; null if no text that is cut has a field.</summary>
    public Plate? Of(DocumentState state) => StateOf(state).Plate;

    /// <summary>The next plate, and why it cannot be engraved.</summary>
    public NextPlate StateOf(DocumentState state)
    {
        ArgumentNullException.ThrowIfNull(state);
        if (state.Drawing is not { Texts.Count: > 0 } drawing || !state.Settings.Cut.HasFlag(CutChoice.Text))
        {
            if (state.Drawing is { Texts.Count: > 0 } uncut) ShownDrawing.Fill(uncut, PlateValues.None);
            return NextPlate.None;
        }

        lock (_guard)
        {
            if (_fileName != drawing.FileName) (_fileName, Csv, Number, Choice) = (drawing.FileName, null, 1, CounterChoice.Ask);
            if (_of is not { } known || !ReferenceEquals(known.Drawing, drawing) || known.Settings != state.Settings) (_of, _next) = ((drawing, state.Settings), Find(drawing, state.Settings));
            var next = _resumed is null || _next.Fields is null ? _next : _next with { Plate = _resumed, Problem = null, Refusal = null };
            ShownDrawing.Fill(drawing, next.Plate?.Values ?? PlateValues.None);
            return next;
        }
    }

    /// <summary>Takes the present date and the present state of the counters.</summary>
    /// <returns>The next plate.</returns>
    public NextPlate Refresh(DocumentState state)
    {
        var before = Of(state);
        lock (_guard) _of = null;
        var now = StateOf(state);
        if (before != now.Plate) RaiseChanged();
        return now;
    }

    /// <summary>Takes the values of further plates from a CSV file, from its first row on.</summary>
    /// <param name="csv">Null for none.</param>
    public void Use(PlateCsv? csv, DocumentState state) => Change(state, () => (Csv, Number) = (csv, 1));

    /// <summary>Sets the number of the next plate.</summary>
    public void GoTo(int number, DocumentState state) => Change(state, () => Number = number);

    /// <summary>Decides about a plate that was not finished, for the next plate.</summary>
    public void Decide(CounterChoice choice, DocumentState state) => Change(state, () => Choice = choice);

    /// <summary>A plate has ended: after a complete one the next is taken.</summary>
    public void End(Plate plate, bool isComplete, DocumentState state)
    {
        ArgumentNullException.ThrowIfNull(plate);
        if (!isComplete)
        {
            Choice = CounterChoice.Ask; // its values remain shown until something is decided
            return;
        }

        Change(state, () =>
        {
            _resumed = null;
            Choice = CounterChoice.Ask;
            if (plate.Number == Number) Number++;
        });
    }

    /// <summary>The next plates, as they are engraved if none is interrupted.</summary>
    /// <param name="most">At most so many; with a CSV file only those of further rows.</param>
    /// <exception cref="CounterException">The counters cannot be read, are damaged or have no further number.</exception>
    public IReadOnlyList<Plate> Forecast(DocumentState state, int most)
    {
        if (StateOf(state) is not { Plate: not null, Fields: { } fields }) return [];
        lock (_guard)
        {
            var count = Csv is null ? most : Math.Min(most, Csv.Table.Rows.Count - Number + 1);
            var (numbers, now) = (book.Forecast(fields.Counters, Choice, count).Plates, time.GetLocalNow());
            return [.. Enumerable.Range(0, count).Select(i => new Plate(Number + i, fields.ValuesOf(Csv?.Table.Rows[Number + i - 1], numbers[i], now, Number + i), default))];
        }
    }

    /// <summary>A plate for people: its number, with a CSV file of how many, and its values.</summary>
    public string TextOf(Plate plate)
    {
        ArgumentNullException.ThrowIfNull(plate);
        return Csv is { Table.Rows.Count: var count } && plate.Number <= count ? Wording.Get("Plates.OfCsv", plate.Number, count, plate) : Wording.Get("Plates.One", plate.Number, plate);
    }

    private void Change(DocumentState state, Action change)
    {
        _ = StateOf(state); // of another drawing the choices are forgotten first
        lock (_guard)
        {
            change();
            _of = null;
        }

        RaiseChanged();
    }

    private void RaiseChanged() => Changed?.Invoke(this, EventArgs.Empty);

    private NextPlate Find(Drawing drawing, DrawingSettings settings)
    {
        try
        {
            var fields = JobPreparation.FieldsOf(drawing, settings);
            if (!fields.Any && (Csv is null || !fields.UsesColumnOf(Csv.Table))) return NextPlate.None;
            var count = Csv?.Table.Rows.Count;
            if (Number > count) return new NextPlate(null, fields, SerialRules.CsvNoSuchRow.At(default, FactText.Of(Number), FactText.Of(count.Value)), null);
            var forecast = book.Forecast(fields.Counters, Choice, 1);
            return new NextPlate(new Plate(Number, fields.ValuesOf(Csv?.Table.Rows[Number - 1], forecast.Plates[0], time.GetLocalNow(), Number), default), fields, null, forecast.Refusal);
        }
        catch (CounterException refused) when (refused.Finding is { } finding)
        {
            return new NextPlate(null, JobPreparation.FieldsOf(drawing, settings), finding, null);
        }
        catch (SettingException)
        {
            return NextPlate.None; // the stages report it
        }
    }
}
