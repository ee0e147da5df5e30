using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.VisualTree;
using Engraver.App.HandMoves;
using Engraver.App.Tabs;
using Engraver.Core.Machines.Moves;

namespace Engraver.App.Tests.RealWindow;

/// <summary>Positions of the keys of the desktop, taken from the same window in memory.</summary>
internal sealed class ControlPositions
{
    private readonly Dictionary<string, Point> _places = [];

    private ControlPositions()
    {
    }

    public Point this[string key] => _places[key];

    /// <param name="profile">File of the machine profile.</param>
    public static async Task<ControlPositions> OfAsync(DesktopFixture fixture, string profile)
    {
        var found = new ControlPositions();
        await fixture.WithOperator(here =>
        {
            here.Hands.Resize(new Size(ShownDesktop.Size.Width, ShownDesktop.Size.Height));
            here.Enter("CNCPROFILE", profile, "CNCCONNECT", "sim:");
            foreach (var key in new[] { "ArmKey", "StartKey", "HoldKey", "StopKey", "SlowerKey", "FasterKey" }) found._places[key] = here.MiddleOf(here.Find<Button>(key));
            foreach (var page in new[] { "Machine", "Job", "Command", "Alarms" }) found._places[page] = TabOf(here, page);
            here.Show("Machine");
            foreach (var cell in here.Find<JogPad>("Pad").GetVisualDescendants().OfType<Border>().Where(cell => cell is { Tag: JogVelocity, Child: TextBlock })) found._places["Pad " + ((TextBlock)cell.Child!).Text] = here.MiddleOf(cell);
            foreach (var step in here.Find<ItemsControl>("StepList").GetVisualDescendants().OfType<ToggleButton>()) found._places["Step " + step.Content] = here.MiddleOf(step);
            foreach (var key in new[] { "ZeroAllKey", "HomeKey" }) found._places[key] = here.MiddleOf(here.Find<Button>(key));
        });
        return found;
    }

    private static Point TabOf(Operator here, string page)
    {
        var tabs = here.Window.GetVisualDescendants().OfType<PageTabs>().First(tabs => tabs.Pages.Any(one => one.Key == page));
        return here.MiddleOf(tabs.GetVisualDescendants().OfType<ListBoxItem>().First(item => item.DataContext is PageTab tab && tab.Key == page));
    }
}
