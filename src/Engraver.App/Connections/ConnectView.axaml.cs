using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.Threading;

namespace Engraver.App.Connections;

/// <summary>A sheet over the canvas instead of a window, so that the machine strip with STOP stays visible.</summary>
public partial class ConnectView : UserControl
{
    public ConnectView() => InitializeComponent();

    private ConnectModel Model => (ConnectModel)DataContext!;

    /// <summary>Enter connects and Esc closes; all other keys go to the focused control.</summary>
    /// <returns>True if the sheet handled the key.</returns>
    public bool Press(KeyEventArgs e)
    {
        if (e.Key == Key.Escape) Model.Cancel.Execute(null);
        else if (e.Key == Key.Enter && e.Source is not ((Button and not ToggleButton) or ComboBox or ComboBoxItem) && Model.Connect.CanExecute(null)) Model.Connect.Execute(null);
        else return false;
        return true;
    }

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == IsVisibleProperty && IsVisible) Dispatcher.UIThread.Post(TakeFocus, DispatcherPriority.Loaded);
    }

    private void TakeFocus()
    {
        if (Model.IsNetwork) HostBox.Focus();
        else if (Model.IsSerial) DeviceBox.Focus();
        else SimulatedChoice.Focus();
    }
}
