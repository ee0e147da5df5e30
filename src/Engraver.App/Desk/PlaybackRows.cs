using Engraver.App.Binding;

namespace Engraver.App.Desk;

/// <summary>A list that follows the playback: the row at the playback position is selected, and selecting another row moves the playback there.</summary>
/// <typeparam name="T">A row; two rows of the same index must be equal.</typeparam>
/// <param name="underTool">Index of the row at the playback position; -1 for none.</param>
/// <param name="moveTo">Moves the playback to a row.</param>
/// <param name="placeOf">Index of a row.</param>
public abstract class PlaybackRows<T>(DesktopModel desk, Func<int> underTool, Action<int> moveTo, Func<T, int> placeOf) : ObservableObject
    where T : class
{
    private int _current = -1;

    public RowList<T> Rows { get; private set; } = new(0, _ => throw new ArgumentOutOfRangeException(nameof(Rows)), placeOf);

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>The row at the playback position; -1 for none.</summary>
    public int Current
    {
        get => _current;
        set
        {
            if (SetProperty(ref _current, value) && value >= 0) moveTo(value);
        }
    }

    protected DesktopModel Desk => desk;

    /// <summary>Subscribes to the desktop model; called last in a constructor.</summary>
    protected void Subscribe()
    {
        desk.Notifications.Changed += Refresh;
        desk.Derived.ToolMoved += RefreshCurrent;
        Refresh();
    }

    /// <summary>Replaces the rows if they have changed.</summary>
    protected abstract void Refresh();

    /// <summary>Shows any number of rows.</summary>
    protected void Show(int count, Func<int, T> make)
    {
        Rows = new RowList<T>(count, make, placeOf);
        OnPropertyChanged(nameof(Rows));
        OnPropertyChanged(nameof(IsEmpty));
        RefreshCurrent();
    }

    private void RefreshCurrent() => SetProperty(ref _current, underTool(), nameof(Current));
}
