using System.Text.Json.Nodes;
using Engraver.Core.Operations;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Files;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Toolpaths;

/// <summary>OPERATION: Loads, saves, lists, adds, edits, orders and deletes the operations of the drawing.</summary>
internal sealed class OperationCommand : ICommand
{
    /// <summary>Largest number of a tool.</summary>
    private const int LastTool = 9999;

    public CommandInfo Info { get; } = new("OPERATION", CommandGroup.Sequence);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var plan = context.Document.Current.Settings.Operations;
        var words = plan is null ? Keyword.List("LOad", "New") : Keyword.List("SHow", "LOad", "Save", "New", "Edit", "SWitch", "Move", "Delete", "STart", "TAbs", "Tool", "cleaR");
        switch (await context.ChoiceAsync(Wording.Get("Operation.EnterOption"), words, plan is null ? "LOad" : "SHow").ConfigureAwait(false))
        {
            case "LOad":
                await LoadAsync(context).ConfigureAwait(false);
                break;
            case "New":
                await AddAsync(context, plan).ConfigureAwait(false);
                break;
            case "SHow":
                context.WriteResult(output => List(output, plan!, context.Document.Current.Settings));
                break;
            case "Save":
                await ResultFile.WriteAsync(context, "operations", ".json", output => output.Write(OperationEdits.ToFile(plan!))).ConfigureAwait(false);
                break;
            case "Edit":
                await EditAsync(context, plan!).ConfigureAwait(false);
                break;
            case "SWitch":
                var switched = await OperationAsync(context, plan!).ConfigureAwait(false);
                Commit(context, OperationEdits.Changed(plan!, switched.Id, "on", switched.IsOn ? "false" : "true"));
                break;
            case "Move":
                var moved = await OperationAsync(context, plan!).ConfigureAwait(false);
                Commit(context, OperationEdits.Moved(plan!, moved.Id, await WholeAsync(context, "Operation.EnterPosition", plan!.Operations.Count).ConfigureAwait(false)));
                break;
            case "Delete":
                var deleted = await OperationAsync(context, plan!).ConfigureAwait(false);
                Commit(context, plan!.Operations.Count == 1 ? null : OperationEdits.Deleted(plan, deleted.Id));
                break;
            case "STart":
                if (await PicksAsync(context, plan!).ConfigureAwait(false) is var starting && await starting.StartsAsync(plan!).ConfigureAwait(false) is { } started) Commit(context, started);
                break;
            case "TAbs":
                if (await PicksAsync(context, plan!).ConfigureAwait(false) is var tabbing && await tabbing.TabsAsync(plan!).ConfigureAwait(false) is { } tabbed) Commit(context, tabbed);
                break;
            case "Tool":
                await ToolAsync(context).ConfigureAwait(false);
                break;
            default:
                Commit(context, null);
                break;
        }
    }

    private static async Task LoadAsync(CommandContext context)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Operation.EnterFile"), new FileRequest("operations", false, ".json"))).ConfigureAwait(false);
        Commit(context, OperationsSource.Load(context.ResolveInputPath(name)));
    }

    private static async Task AddAsync(CommandContext context, OperationPlan? plan)
    {
        var kind = await context.ChoiceAsync(Wording.Get("Operation.EnterKind"), Keyword.List("Engrave", "pRofile", "Pocket", "Fill", "Drill"), "Engrave").ConfigureAwait(false);
        var layers = await context.ValueAsync(new TextPrompt(Wording.Get("Operation.EnterLayers")) { Default = "*" }).ConfigureAwait(false);
        var number = await WholeAsync(context, "Operation.EnterTool", LastTool).ConfigureAwait(false);
        var tool = plan?.Tools.Any(one => one.Number == number) == true ? null : new JsonObject { ["number"] = number, ["diameter"] = await context.ValueAsync(new NumberPrompt(Wording.Get("Operation.EnterDiameter")) { Min = 1e-3, Max = 1e3 }).ConfigureAwait(false) };
        var operation = new JsonObject
        {
            ["id"] = FreeId(plan),
            ["kind"] = kind.ToLowerInvariant(),
            ["select"] = layers == "*" ? "rest" : new JsonObject { ["layers"] = new JsonArray([.. layers.Split(',').Select(name => (JsonNode)name.Trim())]) },
            ["tool"] = number,
        };
        if (kind == nameof(OperationKind.Fill)) operation["spacing"] = await context.ValueAsync(new NumberPrompt(Wording.Get("Operation.EnterSpacing")) { Min = 1e-3, Max = 1e3 }).ConfigureAwait(false);
        if (context.Document.Current.Settings.Machine.Height is not null) operation["depth"] = await context.ValueAsync(new NumberPrompt(Wording.Get("Operation.EnterDepth")) { Min = 1e-6, Max = 1e4 }).ConfigureAwait(false);
        Commit(context, OperationEdits.Added(plan, operation, tool));
    }

    private static string FreeId(OperationPlan? plan) => Enumerable.Range(1, int.MaxValue).Select(number => FormattableString.Invariant($"o{number}")).First(id => plan?.Operations.Any(operation => operation.Id == id) != true);

    private static async Task EditAsync(CommandContext context, OperationPlan plan)
    {
        var operation = await OperationAsync(context, plan).ConfigureAwait(false);
        var field = await context.ValueAsync(new TextPrompt(Wording.Get("Operation.EnterField"))).ConfigureAwait(false);
        var answer = await context.AskAsync(new TextPrompt(Wording.Get("Operation.EnterValue")) { EnterEnds = true }).ConfigureAwait(false);
        Commit(context, OperationEdits.Changed(plan, operation.Id, field, answer is Answer<string>.Value { Result: var value } ? value : ""));
    }

    private static async Task ToolAsync(CommandContext context)
    {
        var number = (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Operation.EnterJobTool")) { Min = 0, Max = LastTool, IsInteger = true, Default = "0" }).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Commit(state with { Settings = state.Settings with { Tool = number } });
    }

    /// <exception cref="CommandException">The operation is not a profile.</exception>
    private static async Task<OperationPicks> PicksAsync(CommandContext context, OperationPlan plan)
    {
        var operation = await OperationAsync(context, plan, plan.Operations.FirstOrDefault(one => one.Kind == OperationKind.Profile)).ConfigureAwait(false);
        return operation.Kind == OperationKind.Profile ? new OperationPicks(context, operation.Id) : throw new CommandException(CommandFailure.Usage, Wording.Get("Operation.NotAProfile", operation.Id));
    }

    private static async Task<int> WholeAsync(CommandContext context, string instruction, int most) =>
        (int)await context.ValueAsync(new NumberPrompt(Wording.Get(instruction)) { Min = 1, Max = most, IsInteger = true, Default = "1" }).ConfigureAwait(false);

    /// <summary>Asks for an operation by its id or name.</summary>
    /// <param name="usual">The default; null for the first one.</param>
    /// <exception cref="CommandException">There is no such operation.</exception>
    private static async Task<Operation> OperationAsync(CommandContext context, OperationPlan plan, Operation? usual = null)
    {
        var typed = await context.ValueAsync(new TextPrompt(Wording.Get("Operation.EnterId")) { Default = (usual ?? plan.Operations[0]).Id }).ConfigureAwait(false);
        return plan.Operations.FirstOrDefault(one => one.Id == typed) ?? plan.Operations.FirstOrDefault(one => string.Equals(one.Name, typed, StringComparison.OrdinalIgnoreCase))
            ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Operation.NotFound", typed, string.Join(", ", plan.Operations.Select(one => one.Id))));
    }

    private static void List(TextWriter output, OperationPlan plan, DrawingSettings settings)
    {
        foreach (var (operation, index) in plan.Operations.Select((one, index) => (one, index)))
        {
            var tool = plan.ToolOf(operation);
            output.WriteLine(Wording.Get(operation.IsOn ? "Operation.Line" : "Operation.LineOff", index + 1, operation.Id, operation.Title, operation.Kind, tool.Title, operation.DepthByWidth ? Wording.Get("Operation.ByWidth") : Wording.Get("Operation.Millimetres", operation.Depth ?? 0.0), plan.FeedOf(operation, settings.Machine)));
        }
    }

    private static void Commit(CommandContext context, OperationPlan? plan)
    {
        var state = context.Document.Current;
        var settings = state.Settings with { Operations = plan, Tool = plan is null ? 0 : state.Settings.Tool };
        if (SettingTable.Operations.Conflict(settings) is { } conflict) throw new CommandException(CommandFailure.Usage, SettingWording.AtCommandLine(conflict));
        context.Commit(state with { Settings = settings, Sidecar = state.Sidecar.WithOperations(plan) });
    }
}
