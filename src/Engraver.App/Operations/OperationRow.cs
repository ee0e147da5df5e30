using System.Globalization;
using Avalonia.Media;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Operations;
using Engraver.Workbench.Documents;

namespace Engraver.App.Operations;

/// <summary>An operation in the list; each button runs OPERATION, so that it can be undone.</summary>
/// <param name="summary">What it cuts in the prepared job; null while there is none, or if it is not run.</param>
/// <param name="colour">Its colour on the canvas, 0xAARRGGBB.</param>
public sealed class OperationRow(OperationPlan plan, Operation operation, OperationSummary? summary, uint colour, DesktopModel desk)
{
    public Operation Operation => operation;

    public IBrush Colour { get; } = new SolidColorBrush(Color.FromUInt32(colour));

    public string Title => operation.Title;

    /// <summary>Kind and tool.</summary>
    public string Detail { get; } = Text.Get("Operations.Detail", Text.Get("OperationKind." + operation.Kind), plan.ToolOf(operation).Title);

    /// <summary>Final depth, mm, or that it follows from the width of each line; empty on a machine without a tool axis.</summary>
    public string Depth => operation.DepthByWidth ? Text.Get("Operations.ByWidth") : operation.Depth?.ToString("0.###", CultureInfo.InvariantCulture) ?? "";

    /// <summary>Number of curves that it takes; empty if that is not known.</summary>
    public string Curves => summary?.Curves.ToString(CultureInfo.InvariantCulture) ?? "";

    public bool IsOn => operation.IsOn;

    public bool CanMoveUp => Place > 1;

    public bool CanMoveDown => Place < plan.Operations.Count;

    public RelayCommand Switch { get; } = new(() => Run(desk, "SWitch", operation.Id));

    public RelayCommand MoveUp { get; } = new(() => Run(desk, "Move", operation.Id, PlaceText(PlaceIn(plan, operation) - 1)));

    public RelayCommand MoveDown { get; } = new(() => Run(desk, "Move", operation.Id, PlaceText(PlaceIn(plan, operation) + 1)));

    public RelayCommand Delete { get; } = new(() => Run(desk, "Delete", operation.Id));

    private int Place => PlaceIn(plan, operation);

    private static string PlaceText(int place) => place.ToString(CultureInfo.InvariantCulture);

    private static int PlaceIn(OperationPlan plan, Operation operation) => plan.Operations.ToList().IndexOf(operation) + 1;

    private static void Run(DesktopModel desk, params string[] answers) => _ = desk.Queue.RunAsync(["OPERATION", .. answers]);
}
