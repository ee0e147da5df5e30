using Engraver.Core.Diagnostics;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>SACEEXPORTTRAJECTORIES: Writes a file for each trajectory into a folder, for the SACE bench or an XPS controller. The list stays.</summary>
internal sealed class SaceExportTrajectoriesCommand : ICommand
{
    /// <summary>The typed options, each with a unique first letter.</summary>
    private static readonly (string Option, TrajectoryFormat Format)[] s_formats =
        [("Sace", TrajectoryFormat.Sace), ("Xps-spline", TrajectoryFormat.XpsSpline), ("Linearc", TrajectoryFormat.XpsLineArc), ("Pvt", TrajectoryFormat.XpsPvt)];

    public CommandInfo Info { get; } = new("SACEEXPORTTRAJECTORIES", CommandGroup.Trajectory);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var all = TrajectorySelection.All(context);
        var option = await context.ChoiceAsync(Wording.Get("Trajectories.Format"), Keyword.List([.. s_formats.Select(one => one.Option)]), context.LastValue("SACE.format", "Sace")).ConfigureAwait(false);
        context.Remember("SACE.format", option);
        var format = s_formats.First(one => one.Option == option).Format;
        var name = await context.ValueAsync(new TextPrompt(Wording.Get("Trajectories.Folder")) { Default = context.LastValue("SACE.folder", ".") }).ConfigureAwait(false);
        context.Remember("SACE.folder", name);
        var folder = context.ResolveOutputPath(name);
        var files = Files(context, all, format);
        await ConfirmErrorsAsync(context, all, format).ConfigureAwait(false);
        if (files.Any(one => File.Exists(Path.Combine(folder, one.FileName))) && !await context.ConfirmAsync(Wording.Get("Trajectories.ReplaceIn", name)).ConfigureAwait(false)) throw new CommandException(CommandFailure.Usage, Wording.Get("ResultFile.NotReplaced", name));
        TrajectoryFolder.Write(folder, files, format);
        context.WriteMessage(Wording.Get("Trajectories.Written", CountText.Format(files.Count, "File"), name));
    }

    /// <summary>Checks the error of formats with equal steps; lines, arcs and velocities are computed from the source and keep the error.</summary>
    /// <exception cref="CommandException">Equal steps exceed the error, and the operator declined.</exception>
    private static async Task ConfirmErrorsAsync(CommandContext context, IReadOnlyList<DocumentTrajectory> all, TrajectoryFormat format)
    {
        if (format is not (TrajectoryFormat.Sace or TrajectoryFormat.XpsSpline) || TrajectoryExport.ErrorsExceeded(all).ToList() is not { Count: > 0 } refused) return;
        FindingMessages.Write(context, context.Drawing.FileName, refused, Severity.Warning);
        if (!await context.ConfirmAsync(Wording.Get("Trajectories.ExportAnyway")).ConfigureAwait(false)) throw new CommandException(CommandFailure.Drawing, Wording.Get("Trajectories.NotExported"));
    }

    /// <exception cref="CommandException">A controller would reject one of them; nothing was written.</exception>
    private static List<NamedTrajectory> Files(CommandContext context, IReadOnlyList<DocumentTrajectory> all, TrajectoryFormat format)
    {
        var (files, findings) = (new List<NamedTrajectory>(), new List<Diagnostic>(TrajectoryEdits.Findings(context.Drawing, all)));
        foreach (var one in all)
        {
            var made = TrajectoryExport.Files(one, format, context.Document.Current.Settings.Machine);
            if (made.Count == 0) findings.Add(TrajectoryRules.ErrorNotKept.At(default, NumberPrompt.Format(one.MaxErrorMm), NumberPrompt.Format(Math.Round(one.Curve.Length, 6)), NumberPrompt.Format(one.Curve.Start.X), NumberPrompt.Format(one.Curve.Start.Y)));
            foreach (var (file, i) in made.Select((file, i) => (file, i)))
            {
                var name = (made.Count == 1 ? one.Name : $"{one.Name}-{i}") + ".txt";
                files.Add(new NamedTrajectory(name, file, one.Handles.Count > 0 ? one.Handles[0] : null, 0.0));
                findings.AddRange(TrajectoryFindings.LimitsOf(file, name, TrajectoryMotion.Of(context.Document.Current.Settings.Machine)));
            }
        }

        FindingMessages.Write(context, context.Drawing.FileName, findings, Severity.Warning);
        return findings.TrueForAll(found => found.Severity < Severity.Error) ? files : throw new CommandException(CommandFailure.Drawing, Wording.Get("Trajectories.NotExported"));
    }
}
