using Engraver.Core.Trajectories;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEEDITTRAJECTORY: Changes one trajectory: its name, its height, its error or steps (it is recomputed), its place in the list, or deletes
/// it.</summary>
internal sealed class SaceEditTrajectoryCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_actions = Keyword.List("Name", "Z", "Error", "Steps", "Up", "DOwn", "Delete");

    public CommandInfo Info { get; } = new("SACEEDITTRAJECTORY", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var at = await TrajectorySelection.PickOneAsync(context).ConfigureAwait(false);
        var change = await context.ChoiceAsync(Wording.Get("Trajectories.WhatToChange"), s_actions, null).ConfigureAwait(false);
        List<DocumentTrajectory> all = [.. TrajectorySelection.All(context)];
        if (change is "Up" or "DOwn")
        {
            var to = change == "Up" ? at - 1 : at + 1;
            if (to < 0 || to >= all.Count) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.AtTheEnd", all[at].Name));
            (all[at], all[to]) = (all[to], all[at]);
        }
        else if (change == "Delete")
        {
            context.WriteMessage(Wording.Get("Trajectories.Deleted", all[at].Name));
            all.RemoveAt(at);
        }
        else
        {
            all[at] = await ChangedAsync(context, all[at], change).ConfigureAwait(false);
            context.WriteMessage(TrajectoryLine.Format(all[at]), MessageKind.Result);
        }

        TrajectoryChange.All(context, all);
    }

    private static Task<DocumentTrajectory> ChangedAsync(CommandContext context, DocumentTrajectory one, string change) => change switch
    {
        "Name" => RenamedAsync(context, one),
        "Z" => RaisedAsync(context, one),
        "Error" => WithErrorAsync(context, one),
        _ => WithStepsAsync(context, one),
    };

    private static async Task<DocumentTrajectory> RenamedAsync(CommandContext context, DocumentTrajectory one)
    {
        var name = await context.ValueAsync(new TextPrompt(Wording.Get("Trajectories.NewName")) { Default = one.Name }).ConfigureAwait(false);
        if (!DocumentTrajectory.IsName(name)) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.InvalidName", name));
        var taken = context.Document.Current.Sidecar.Trajectories.IndexOf(name) is >= 0 and var other && !ReferenceEquals(TrajectorySelection.All(context)[other], one);
        return taken ? throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.NameTaken", name)) : one with { Name = name };
    }

    private static async Task<DocumentTrajectory> RaisedAsync(CommandContext context, DocumentTrajectory one)
    {
        var z = await context.ValueAsync(new NumberPrompt(Wording.Get("Trajectories.NewZ")) { Default = NumberPrompt.Format(one.Curve.Z), Min = -1e6, Max = 1e6 }).ConfigureAwait(false);
        return one with { Curve = one.Curve.Moved(z) };
    }

    private static async Task<DocumentTrajectory> WithErrorAsync(CommandContext context, DocumentTrajectory one)
    {
        var error = await context.ValueAsync(new NumberPrompt(Wording.Get("Trajectories.NewError")) { Default = NumberPrompt.Format(one.MaxErrorMm), Min = 1e-6, Max = 1000.0 }).ConfigureAwait(false);
        return Rebuilt(one, new TrajectoryOptions(error));
    }

    private static async Task<DocumentTrajectory> WithStepsAsync(CommandContext context, DocumentTrajectory one)
    {
        var length = await context.ValueAsync(new NumberPrompt(Wording.Get("Trajectories.NewSteps")) { Default = NumberPrompt.Format(one.SegmentLengthMm ?? TrajectorySettings.Default.SegmentLengthMm), Min = 1e-6, Max = 1e6 }).ConfigureAwait(false);
        return Rebuilt(one, new TrajectoryOptions(one.MaxErrorMm) { SegmentLength = length });
    }

    /// <summary>Recomputes it from its source; it remains one trajectory, also across corners.</summary>
    private static DocumentTrajectory Rebuilt(DocumentTrajectory one, TrajectoryOptions options)
    {
        if (one.IsHelix) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.HelixNotEditable", one.Name));
        var planned = TrajectoryPlanner.Plan(one.Curve.Source, one.Curve.Closed, options with { Corners = CornerMode.Continuous, Z = one.Curve.Z });
        if (planned.Trajectories is not [var made]) throw new CommandException(CommandFailure.Drawing, Wording.Get("Trajectories.NoneMade"));
        return one with { Curve = made, MaxErrorMm = options.MaxError, SegmentLengthMm = options.SegmentLength };
    }
}
