using System.Text.Json.Nodes;
using Engraver.Core.Geometry;
using Engraver.Core.Operations;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Commands.Toolpaths;

/// <summary>OPERATION, STart and TAbs: starts and tabs at places that are picked on the drawing.</summary>
/// <param name="context">The running command.</param>
/// <param name="id">Id of the operation.</param>
internal sealed class OperationPicks(CommandContext context, string id)
{
    /// <summary>Rounding of a place that was mapped to the placed drawing and back, mm.</summary>
    private const double Rounding = 1e-6;

    /// <summary>Asks for starts until Enter. A place that is near no contour is refused; a new start of a contour replaces the one that it has.</summary>
    /// <returns>The plan with the starts; null without a change.</returns>
    public async Task<OperationPlan?> StartsAsync(OperationPlan plan)
    {
        var changed = (OperationPlan?)null;
        while (true)
        {
            var prompt = new PointPrompt(Wording.Get("Operation.SpecifyStart")) { EnterEnds = true, Options = Keyword.List("Clear"), Purpose = PointPurpose.Object };
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var point }:
                    var start = InFile(point);
                    var places = Find(plan).StartAt.Append(start).ToList();
                    var unused = PlacesIn(With(plan, "start", "at", ListOf(places)))?.UnusedStarts ?? [];
                    if (IsIn(unused, start)) context.WriteMessage(Wording.Get("Operation.NoContour"));
                    else changed = plan = With(plan, "start", "at", ListOf([.. places.Where(place => !IsIn(unused, place))]));
                    break;
                case Answer<Point2D>.SelectedOption:
                    changed = plan = With(plan, "start", "at", null);
                    break;
                default:
                    return changed;
            }
        }
    }

    /// <summary>Asks for tabs to add, move or remove until Enter. With the first change the tabs that the operation has remain where they are.</summary>
    /// <returns>The plan with the tabs; null without a change.</returns>
    public async Task<OperationPlan?> TabsAsync(OperationPlan plan)
    {
        var changed = (OperationPlan?)null;
        while (true)
        {
            var tabs = (PlacesIn(plan)?.Tabs ?? Find(plan).Tabs?.At ?? []).ToList();
            var prompt = new PointPrompt(Wording.Get("Operation.SpecifyTab", tabs.Count)) { EnterEnds = true, Options = Keyword.List("Move", "Remove", "Clear"), Purpose = PointPurpose.Object };
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<Point2D>.Value { Result: var point }:
                    tabs.Add(InFile(point));
                    break;
                case Answer<Point2D>.SelectedOption { Option: "Clear" }:
                    tabs.Clear();
                    break;
                case Answer<Point2D>.SelectedOption { Option: var option }:
                    if (tabs.Count == 0)
                    {
                        context.WriteMessage(Wording.Get("Operation.NoTabs"));
                        continue;
                    }

                    tabs.Remove(await NearestAsync(tabs).ConfigureAwait(false));
                    if (option == "Move") tabs.Add(InFile(await context.ValueAsync(new PointPrompt(Wording.Get("Operation.SpecifyNewPlace"))).ConfigureAwait(false)));
                    break;
                default:
                    return changed;
            }

            if (Find(plan).Tabs is null) plan = await SizedAsync(plan).ConfigureAwait(false);
            var next = At(plan, tabs);
            var made = PlacesIn(next)?.Tabs ?? tabs;
            if (made.Count < tabs.Count) context.WriteMessage(Wording.Get("Operation.NoRoom"));
            else changed = plan = At(next, made);
        }
    }

    private OperationPlan At(OperationPlan plan, IReadOnlyList<Point2D> tabs) => With(With(With(plan, "tabs", "at", ListOf(tabs)), "tabs", "count", null), "tabs", "spacing", null);

    private async Task<Point2D> NearestAsync(List<Point2D> tabs)
    {
        var picked = InFile(await context.ValueAsync(new PointPrompt(Wording.Get("Operation.SelectTab")) { Purpose = PointPurpose.Object }).ConfigureAwait(false));
        return tabs.MinBy(tab => tab.DistanceTo(picked));
    }

    /// <summary>Asks for the size of the first tab.</summary>
    private async Task<OperationPlan> SizedAsync(OperationPlan plan)
    {
        var tabs = new JsonObject { ["at"] = new JsonArray() };
        tabs["width"] = await context.ValueAsync(new NumberPrompt(Wording.Get("Operation.EnterTabWidth")) { Min = 1e-3, Max = 1e3 }).ConfigureAwait(false);
        if (Find(plan).Depth is { } depth) tabs["height"] = await context.ValueAsync(new NumberPrompt(Wording.Get("Operation.EnterTabHeight")) { Min = 1e-6, Max = depth }).ConfigureAwait(false);
        return OperationEdits.Changed(plan, id, "tabs", tabs.ToJsonString());
    }

    private Operation Find(OperationPlan plan) => plan.Operations.First(operation => operation.Id == id);

    /// <summary>Tabs and starts as the job would have them, on the drawing of the file; null when it cannot be made.</summary>
    private DressedPlaces? PlacesIn(OperationPlan plan)
    {
        var settings = context.Document.Current.Settings with { Operations = plan, Tool = Find(plan).Tool };
        return JobPreparation.To<OrderedJob>(context.Drawing, settings, context.PlateValues).Places.FirstOrDefault(places => places.Operation == id) is { } placed
            ? placed with { Tabs = [.. placed.Tabs.Select(context.Drawing.Unplaced)], UnusedStarts = [.. placed.UnusedStarts.Select(context.Drawing.Unplaced)] }
            : null;
    }

    /// <summary>A place on the canvas as operations have it: millimetres on the drawing of the file.</summary>
    private Point2D InFile(Point2D picked) => context.Drawing.Unplaced(context.Drawing.Scale.ToMillimetres(picked));

    private static bool IsIn(IReadOnlyList<Point2D> places, Point2D place) => places.Any(one => one.DistanceTo(place) <= Rounding);

    private OperationPlan With(OperationPlan plan, string field, string inner, JsonNode? value) => OperationEdits.Changed(plan, id, field, inner, value);

    private static JsonArray ListOf(IReadOnlyList<Point2D> places) => [.. places.Select(place => (JsonNode)new JsonArray(place.X, place.Y))];
}
