using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace Engraver.App.Binding;

/// <summary>The state behind one view; raises an event when it has changed. UI thread only.</summary>
public abstract class ObservableObject : INotifyPropertyChanged
{
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <returns>True if the value has changed.</returns>
    protected bool SetProperty<T>(ref T field, T value, [CallerMemberName] string? name = null)
    {
        if (EqualityComparer<T>.Default.Equals(field, value)) return false;
        field = value;
        OnPropertyChanged(name);
        return true;
    }

    /// <param name="name">Null: all properties may have changed.</param>
    protected void OnPropertyChanged(string? name) => PropertyChanged?.Invoke(this, new PropertyChangedEventArgs(name));
}
