using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Engraver.App.Binding;
using Engraver.App.Canvas;
using Engraver.App.CommandWindow;
using Engraver.App.Desk;
using Engraver.App.HandMoves;
using Engraver.App.Menus;
using Engraver.App.Safety;

namespace Engraver.App.Shell;

/// <summary>The window of the desktop. Keys typed in it go to the command line, unless a text box has the focus.</summary>
public partial class ShellWindow : Window
{
    private readonly DesktopModel _desk;
    private readonly StopKeys _stopKeys;
    private readonly FileQuestions _files;
    private readonly PanelSizes _panels;
    private readonly ClosingGuard _guard;

    public ShellWindow(DesktopModel desk, StopKeys stopKeys)
    {
        (_desk, _stopKeys) = (desk, stopKeys);
        InitializeComponent();
        _files = new FileQuestions(desk, () => StorageProvider);
        _guard = new ClosingGuard(desk);
        DataContext = Model = new ShellModel(desk, ActOf);
        var menus = new MenuBuilder(name => MenuTitle.Typed(desk.Session, name), ActOf);
        MainMenu.ItemsSource = menus.Build(MenuLayout.For(desk.Session.Catalog));
        Palettes.SetPages(Model.Palettes(), "Layers");
        Pages.SetPages(Model.Pages(), "Command");
        CanvasPlace.Child = Canvas;
        Canvas.Commands = new CanvasCommands(desk, Model.Command.Cancel, Model.Status.Point, () => new ContextMenu { ItemsSource = menus.Entries(MenuLayout.OnCanvas) }.Open(Canvas));
        CanvasSource = new CanvasSource(desk, Canvas);
        _panels = new PanelSizes(desk, Rows, Columns, Pages, Palettes);
        (Width, Height) = (desk.Session.Settings.Current.WindowWidth, desk.Session.Settings.Current.WindowHeight);
        if (desk.Session.Settings.Current.WindowMaximised) WindowState = WindowState.Maximized;
        _ = new WindowPresence(this, desk);
        MainMenu.Closed += GiveKeyboardBack;
        AddHandler(TextInputEvent, OnTyped, RoutingStrategies.Tunnel);
        AddHandler(KeyDownEvent, OnKey, RoutingStrategies.Tunnel);
    }

    public ShellModel Model { get; }

    public DrawingCanvas Canvas { get; } = new();

    public CanvasSource CanvasSource { get; }

    /// <summary>The area of STOP in the window.</summary>
    public Rect StopArea => MachineStrip.StopAreaIn(this);

    private CommandWindowView CommandLine => (CommandWindowView)Pages.Pages[0].Page;

    protected override void OnClosing(WindowClosingEventArgs e)
    {
        base.OnClosing(e);
        if (_guard.Holds(e.CloseReason))
        {
            _panels.BringCommandLine();
            e.Cancel = true;
            return;
        }

        _panels.Keep();
        var maximised = WindowState == WindowState.Maximized;
        _desk.Session.Settings.Change(settings => maximised ? settings with { WindowMaximised = true } : settings with { WindowMaximised = false, WindowWidth = Width, WindowHeight = Height });
    }

    /// <summary>The command of an entry of menus and tools.</summary>
    private Act ActOf(string name) => name switch
    {
        "Window.Exit" => new Act(() => Close()),
        "Window.Palettes" => new Act(() => _panels.FoldPalettes()),
        "Window.Pages" => new Act(() => _panels.FoldPages()),
        "Window.Clean" => new Act(() => _panels.FoldAll()),
        "Window.History" => new Act(() => _panels.ExpandHistory()),
        "Window.SelectAll" => new Act(SelectAll),
        "Window.EraseSelected" => new Act(EraseSelected),
        "Override.FeedFaster" => Model.Machine.Faster,
        "Override.FeedSlower" => Model.Machine.Slower,
        "Override.RapidsFaster" => Model.Machine.RapidsFaster,
        "Override.RapidsSlower" => Model.Machine.RapidsSlower,
        _ when name.StartsWith("Switch.", StringComparison.Ordinal) => Model.Status.Switches.First(toggle => toggle.Command == name["Switch.".Length..]).Switch,
        "CNCCONNECT" => new Act(AskForController),
        _ => new Act(() => _ = _files.RunAsync(name)),
    };

    private void AskForController()
    {
        if (_files.WantsDialogs) Model.Connect.Open();
        else _ = _files.RunAsync("CNCCONNECT");
    }

    /// <summary>Selects everything: as an answer where objects are asked for, else for the next command.</summary>
    private void SelectAll()
    {
        if (_desk.Prompt.Options.Any(option => option.Name == "ALL")) _ = _desk.EnterAsync("ALL");
        else if (_desk.Prompt.Command is null) _ = _desk.RunAsync("SELECT", "ALL", "");
    }

    private void EraseSelected()
    {
        if (_desk.Prompt.Command is null && _desk.Session.Document.Current.Selection.Count > 0) _ = _desk.RunAsync("ERASE");
    }

    /// <summary>Takes the focus from a menu that has closed, so that the next keys go to the command line.</summary>
    private void GiveKeyboardBack(object? sender, RoutedEventArgs e)
    {
        if (FocusManager?.GetFocusedElement() is MenuItem) FocusManager.Focus(null);
    }

    /// <summary>True where a control that uses keys itself has the focus: a text box, an open menu, a slider.</summary>
    private static bool HasKeyboard(object? source) => source is TextBox or MenuItem or Slider;

    private void OnTyped(object? sender, TextInputEventArgs e)
    {
        if (HasKeyboard(e.Source) || Model.Connect.IsOpen || string.IsNullOrEmpty(e.Text)) return;
        _panels.BringCommandLine();
        CommandLine.Type(e.Text);
        e.Handled = true;
    }

    private void OnKey(object? sender, KeyEventArgs e)
    {
        e.Handled = _stopKeys.Press(e.Key, e.KeyModifiers);
        if (e.Handled || e.Source is MenuItem || JogPad.Takes(e.Source, e.Key)) return;
        if (Model.Connect.IsOpen)
        {
            e.Handled = ConnectSheet.Press(e);
            return;
        }

        if (!HasKeyboard(e.Source) && e is { Key: Key.V, KeyModifiers: KeyModifiers.Control })
        {
            _panels.BringCommandLine();
            _ = CommandLine.PasteAsync();
            e.Handled = true;
            return;
        }

        e.Handled = e.Key == Key.Escape ? Escape() : CommandOf(e) is { } command ? Run(command) : !HasKeyboard(e.Source) && e.KeyModifiers == KeyModifiers.None && CommandLine.Press(e.Key);
    }

    /// <summary>The command of a key; null for none, and for keys that edit text while a text box other than the empty command line has the focus.</summary>
    private string? CommandOf(KeyEventArgs e) =>
        ShellKeys.CommandOf(e) ?? (e.Source is TextBox box && (box != CommandLine.LineBox || box.Text is { Length: > 0 }) ? null : ShellKeys.CommandOutsideText(e));

    private bool Escape()
    {
        Canvas.Escape();
        return true;
    }

    private bool Run(string command)
    {
        ActOf(command).Execute(null);
        return true;
    }
}
