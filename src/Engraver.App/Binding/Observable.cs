using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace Engraver.App.Binding;

/// <summary>The state behind one view; raises an event when it has changed. UI thread only.</summary>
public abstract class Observable : INotifyPropertyChanged
{
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <returns>True if the value has changed.</returns>
    protected bool Set<T>(ref T field, T value, [CallerMemberName] string? name = null)
    {
        if (EqualityComparer<T>.Default.Equals(field, value)) return false;
        field = value;
        Tell(name);
        return true;
    }

    /// <param name="name">Null: all properties may have changed.</param>
    protected void Tell(string? name) => PropertyChanged?.Invoke(this, new PropertyChangedEventArgs(name));
}

/// <summary>State of a page that computes nothing while the page is hidden and is updated when it becomes visible.</summary>
public interface ISeen
{
    /// <summary>The page is in front and its panel is open.</summary>
    bool IsSeen { get; set; }
}
