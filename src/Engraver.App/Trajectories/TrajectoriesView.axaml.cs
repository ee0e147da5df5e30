using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;

namespace Engraver.App.Trajectories;

/// <summary>The table of trajectories.</summary>
public partial class TrajectoriesView : UserControl
{
    public TrajectoriesView() => InitializeComponent();

    /// <summary>Enter accepts the text, as leaving the field does.</summary>
    private void OnKey(object? sender, KeyEventArgs e)
    {
        if (e.Key != Key.Enter || sender is not TextBox box) return;
        e.Handled = true;
        BindingOperations.GetBindingExpressionBase(box, TextBox.TextProperty)?.UpdateSource();
    }
}
