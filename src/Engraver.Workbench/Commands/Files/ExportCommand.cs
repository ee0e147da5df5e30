using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Plots;
using Engraver.Core.Posts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Files;

/// <summary>EXPORT: Writes the file format given by the extension: .svg picture of the path, .csv or .json entity table, .dmc program, .dxf CL data.</summary>
internal sealed class ExportCommand : ICommand
{
    private static readonly IReadOnlyList<string> s_extensions = [".svg", ".csv", ".json", .. PostTable.All.Select(entry => entry.Post.FileExtension).Distinct()];

    public CommandInfo Info { get; } = new("EXPORT", CommandGroup.File);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var name = await ReplacePrompt.AskAsync(context, Wording.Get("Export.EnterFileName", string.Join(' ', s_extensions)), new FileRequest("export", true, s_extensions) { Suggested = context.PathBesideDrawing(s_extensions[0]) }).ConfigureAwait(false);
        var (write, forecast) = Writer(context, Path.GetExtension(name).ToLowerInvariant()) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Export.UnknownExtension", name, string.Join(", ", s_extensions)));
        OutputFile.Write(context.ResolveOutputPath(name), write);
        ProgramStart.Save(context.ResolveOutputPath(name), forecast);
        if (Program(Path.GetExtension(name).ToLowerInvariant()) is { } post) context.Remember(HistoryEntry.OfPost(drawing, context.Document.Current.Settings, post.Name, PostedProgram.NoOptions, context.ResolveOutputPath(name), context.Time.GetUtcNow()));
        context.WriteMessage(Wording.Get("Export.WrittenFrom", name, Path.GetFileName(drawing.FileName)));
    }

    /// <exception cref="CommandException">There is nothing to write.</exception>
    private static (Action<TextWriter> Write, PostForecast? Forecast)? Writer(CommandContext context, string ending)
    {
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        switch (ending)
        {
            case ".svg":
                var plot = DrawingPlot.Create(drawing, settings, asDrawn: false, context.PlateValues);
                return (output => SvgPlotWriter.Write(plot, output), null);
            case ".csv" or ".json":
                var (table, findings) = JobPreparation.CutTableOf(drawing, settings, context.PlateValues);
                FindingMessages.Write(context, drawing.FileName, findings, Severity.Warning);
                return (output => EntityTableFormat.Write(ending[1..], table, output), null);
            default: return Program(ending) is { } post ? Program(context, post) : null;
        }
    }

    /// <summary>The post for a file extension; null if it is not a program.</summary>
    private static IPost? Program(string ending) => ending is ".svg" or ".csv" or ".json" ? null : PostTable.ForExtension(ending)?.Post;

    private static (Action<TextWriter> Write, PostForecast? Forecast) Program(CommandContext context, IPost post)
    {
        var posted = PostedProgram.Create(context.Drawing, context.Document.Current.Settings, post, PostedProgram.NoOptions, context.PlateValues);
        FindingMessages.Write(context, context.Drawing.FileName, posted.Diagnostics, Severity.Warning);
        return posted.Text is { } text ? (output => output.Write(text), posted.Forecast) : throw new CommandException(CommandFailure.Drawing, $"{posted.NoProgramReason}.");
    }
}
