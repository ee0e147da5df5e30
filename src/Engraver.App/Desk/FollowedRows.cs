using Engraver.App.Binding;

namespace Engraver.App.Desk;

/// <summary>A list that follows the playback: the row under the tool is chosen, and choosing another row moves the tool there.</summary>
/// <typeparam name="T">A row; two of the same place must be equal.</typeparam>
/// <param name="underTool">Place of the row under the tool; -1 for none.</param>
/// <param name="moveTo">Moves the tool to a row.</param>
/// <param name="placeOf">Place of a row.</param>
public abstract class FollowedRows<T>(DesktopModel desk, Func<int> underTool, Action<int> moveTo, Func<T, int> placeOf) : Observable
    where T : class
{
    private int _current = -1;

    public RowList<T> Rows { get; private set; } = new(0, _ => throw new ArgumentOutOfRangeException(nameof(Rows)), placeOf);

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>The row under the tool; -1 for none.</summary>
    public int Current
    {
        get => _current;
        set
        {
            if (Set(ref _current, value) && value >= 0) moveTo(value);
        }
    }

    protected DesktopModel Desk => desk;

    /// <summary>Begins to follow the desktop model; called last in a constructor.</summary>
    protected void Follow()
    {
        desk.Notifications.Changed += Look;
        desk.Derived.Moved += LookWhereToolIs;
        Look();
    }

    /// <summary>Replaces the rows when they have changed.</summary>
    protected abstract void Look();

    /// <summary>Shows rows, however many.</summary>
    protected void Show(int count, Func<int, T> make)
    {
        Rows = new RowList<T>(count, make, placeOf);
        Tell(nameof(Rows));
        Tell(nameof(IsEmpty));
        LookWhereToolIs();
    }

    private void LookWhereToolIs() => Set(ref _current, underTool(), nameof(Current));
}
