using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Sets the zero by touching the workpiece: at its edges, or at the centre of two touches. Other commands move the machine between two touches, so
/// each touch is a separate command.</summary>
internal static class TouchedZero
{
    private const string Radius = "CNCZERO.Radius";
    private const string Edge = "CNCZERO.Edge";
    private const double MaxRadiusMm = 100.0;

    private static readonly IReadOnlyList<Keyword> s_edges = Keyword.List([.. Enum.GetNames<WorkEdge>()]);
    private static readonly IReadOnlyList<Keyword> s_axes = Keyword.List("All", "X", "Y");
    private static readonly IReadOnlyList<Keyword> s_touches = Keyword.List("Second", "First");

    /// <summary>The tool touches an edge: the zero is on the edge, one tool radius away.</summary>
    public static async Task ByEdgeAsync(CommandContext context, CancellationToken cancellation)
    {
        var edge = Enum.Parse<WorkEdge>(await context.ChoiceAsync(Wording.Get("CncZero.EnterEdge"), s_edges, context.LastValue(Edge, nameof(WorkEdge.Left))).ConfigureAwait(false));
        var radius = await context.ValueAsync(new NumberPrompt(Wording.Get("CncZero.SpecifyToolRadius")) { Default = context.LastValue(Radius, "0"), Min = 0.0, Max = MaxRadiusMm }).ConfigureAwait(false);
        var isX = edge is WorkEdge.Left or WorkEdge.Right;
        if (!await ConfirmSetAsync(context, isX, !isX).ConfigureAwait(false)) return;
        context.Remember(Radius, radius.ToString("R", CultureInfo.InvariantCulture));
        await SetAsync(context, new ZeroTouch { X = isX, Y = !isX, Edge = edge, Radius = radius }, cancellation).ConfigureAwait(false);
        context.Remember(Edge, isX ? nameof(WorkEdge.Bottom) : nameof(WorkEdge.Left));
        context.WriteMessage(Wording.Get(isX ? "CncZero.TouchBottomNext" : "CncZero.TouchLeftOrRightNext"));
    }

    /// <summary>The first touch is remembered; the second sets the zero to the centre of both.</summary>
    public static async Task ByCentreAsync(CommandContext context, CancellationToken cancellation)
    {
        var isSecond = context.Machine.Origins.FirstTouch is { } before
            && await context.ChoiceAsync(Wording.Get("CncZero.EnterTouch", Show(context, before)), s_touches, "Second").ConfigureAwait(false) == "Second";
        if (!isSecond || context.Machine.Origins.FirstTouch is not { } first)
        {
            var at = await context.Machine.Origins.TouchAsync(cancellation).ConfigureAwait(false);
            context.WriteMessage(Wording.Get("CncZero.FirstTouch", Show(context, at)), MessageKind.Result);
            return;
        }

        var axes = await context.ChoiceAsync(Wording.Get("CncZero.EnterCentreAxes"), s_axes, "All").ConfigureAwait(false);
        if (!await ConfirmSetAsync(context, axes != "Y", axes != "X").ConfigureAwait(false)) return;
        await SetAsync(context, new ZeroTouch { X = axes != "Y", Y = axes != "X", First = first }, cancellation).ConfigureAwait(false);
        context.Machine.Origins.ForgetTouch();
    }

    private static async Task<bool> ConfirmSetAsync(CommandContext context, bool x, bool y)
    {
        var memory = context.Machine.Connection.Lease!.Memory;
        var isSet = memory.ActiveOrigin is { IsAssumed: false } origin && ((x && origin.X is not null) || (y && origin.Y is not null));
        return !isSet || await context.ConfirmAsync(Wording.Get("CncZero.ConfirmReplace", memory.Active)).ConfigureAwait(false);
    }

    private static async Task SetAsync(CommandContext context, ZeroTouch touch, CancellationToken cancellation)
    {
        var part = context.Machine.Runs.Part;
        await OriginText.SetAsync(context, touch, cancellation).ConfigureAwait(false);
        OriginText.WarnResumeDropped(context, part);
    }

    private static string Show(CommandContext context, CountsPoint at)
    {
        var scale = context.Machine.Profile.Scale;
        return PointPrompt.Format(scale.ToMillimetres(at.X, at.Y));
    }
}
