using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>The inserts of a drawing while its curves are edited: an insertion point moves, is copied or is erased when every curve of its insert is, and those
/// nested in it with it.</summary>
internal sealed class EditedInserts
{
    private readonly Drawing _drawing;
    private readonly int[] _curves;
    private readonly int[] _taken;

    /// <param name="entities">The edited curves, each once.</param>
    public EditedInserts(Drawing drawing, IEnumerable<int> entities)
    {
        _drawing = drawing;
        (_curves, _taken) = (new int[drawing.Inserts.Count], new int[drawing.Inserts.Count]);
        if (_curves.Length == 0) return;
        for (var entity = 0; entity < drawing.Entities.Count; entity++) Count(_curves, entity);
        foreach (var entity in entities) Count(_taken, entity);
    }

    /// <summary>True for an insert without a curve that is not nested in one that has curves: it cannot be selected.</summary>
    public bool IsFree(int insert)
    {
        for (var number = insert + 1; number > 0; number = _drawing.Inserts[number - 1].Around)
        {
            if (_curves[number - 1] > 0) return false;
        }

        return true;
    }

    /// <summary>The inserts, the edited ones moved.</summary>
    public IReadOnlyList<PlacedInsert> Moved(Transform2D map) => Changed(insert => insert.Moved(map));

    /// <summary>The inserts, the edited ones marked as erased.</summary>
    public IReadOnlyList<PlacedInsert> Erased() => Changed(insert => insert with { IsErased = true });

    /// <summary>The inserts, followed by copies of the edited ones.</summary>
    /// <param name="copyOf">The number of an insert in a copy: that of its own copy, or unchanged when only a part of it is copied.</param>
    public IReadOnlyList<PlacedInsert> Copied(Transform2D map, out Func<int, int> copyOf)
    {
        var (copies, numbers) = (new List<PlacedInsert>(), new Dictionary<int, int>());
        for (var insert = 0; insert < _curves.Length; insert++)
        {
            if (!IsWhole(insert)) continue;
            var placed = _drawing.Inserts[insert];
            copies.Add(placed.Moved(map) with { Around = numbers.GetValueOrDefault(placed.Around, placed.Around) }); // the one around it comes first
            numbers[insert + 1] = _curves.Length + copies.Count;
        }

        copyOf = number => numbers.GetValueOrDefault(number, number);
        return copies.Count == 0 ? _drawing.Inserts : [.. _drawing.Inserts, .. copies];
    }

    private IReadOnlyList<PlacedInsert> Changed(Func<PlacedInsert, PlacedInsert> edit) =>
        Enumerable.Range(0, _curves.Length).Any(IsWhole) ? [.. _drawing.Inserts.Select((insert, index) => IsWhole(index) ? edit(insert) : insert)] : _drawing.Inserts;

    /// <summary>True when every curve of an insert is edited; one without curves follows the one around it.</summary>
    private bool IsWhole(int insert)
    {
        for (var number = insert + 1; number > 0; number = _drawing.Inserts[number - 1].Around)
        {
            if (_curves[number - 1] > 0) return _taken[number - 1] == _curves[number - 1];
        }

        return false;
    }

    private void Count(int[] counts, int entity)
    {
        for (var number = _drawing.Entities[entity].Insert; number > 0; number = _drawing.Inserts[number - 1].Around) counts[number - 1]++;
    }
}
