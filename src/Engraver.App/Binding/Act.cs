using System.Windows.Input;

namespace Engraver.App.Binding;

/// <summary>The command (in Avalonia's sense) of a button or a menu item.</summary>
public sealed class Act(Action<object?> what, Func<bool>? possible = null) : ICommand
{
    public Act(Action what, Func<bool>? possible = null)
        : this(_ => what(), possible)
    {
    }

    public event EventHandler? CanExecuteChanged;

    public bool CanExecute(object? parameter) => possible?.Invoke() ?? true;

    public void Execute(object? parameter) => what(parameter);

    /// <summary>Makes buttons and menu items query <see cref="CanExecute"/> again.</summary>
    public void Reconsider() => CanExecuteChanged?.Invoke(this, EventArgs.Empty);
}
