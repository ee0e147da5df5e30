using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.Threading;

namespace Engraver.App.Options;

/// <summary>A sheet over the window below the machine strip, so that STOP stays visible.</summary>
public partial class OptionsView : UserControl
{
    public OptionsView()
    {
        InitializeComponent();
        OptionPages.ContainerPrepared += (_, e) => e.Container.Focusable = true; // list items are not focusable elsewhere (Theme/Controls.axaml)
        OptionPages.SelectionChanged += (_, _) => FocusShownPageOnTab();
    }

    private OptionsModel Model => (OptionsModel)DataContext!;

    /// <summary>Enter accepts, also on a check box, which Space toggles; Esc closes. All other keys go to the focused control.</summary>
    /// <returns>True if the sheet handled the key.</returns>
    public bool Press(KeyEventArgs e)
    {
        if (e.Source is ComboBox { IsDropDownOpen: true } or ComboBoxItem) return false; // the keys belong to the open list
        if (e.Key == Key.Escape) Model.Cancel.Execute(null);
        else if (e.Key == Key.Enter && e.Source is not ((Button and not ToggleButton) or ComboBox or ComboBoxItem)) Model.Accept.Execute(null);
        else return false;
        return true;
    }

    /// <summary>Tab moves to the shown page, from which the arrow keys continue, instead of the first of the list.</summary>
    private void FocusShownPageOnTab()
    {
        if (OptionPages.SelectedItem is { } page) KeyboardNavigation.SetTabOnceActiveElement(OptionPages, OptionPages.ContainerFromItem(page));
    }

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == IsVisibleProperty && IsVisible) Dispatcher.UIThread.Post(() => SearchBox.Focus(), DispatcherPriority.Loaded);
    }
}
