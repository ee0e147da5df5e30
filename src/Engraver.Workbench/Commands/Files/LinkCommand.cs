using Engraver.Core.Diagnostics;
using Engraver.Core.Posts.Agie;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Commands.Files;

/// <summary>LINK: Combines the AGIE programs of several contours to one program, with positioning blocks between them (paper 000).</summary>
internal sealed class LinkCommand : ICommand
{
    private const string Name = "LINK";

    public CommandInfo Info { get; } = new(Name, CommandGroup.Output);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var contours = new List<AgieContour>();
        while (await NextAsync(context, contours.Count).ConfigureAwait(false) is { } contour) contours.Add(contour);
        if (contours.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Link.NoProgram"));
        var linked = AgieLink.Link(contours);
        FindingMessages.Write(context, Name, linked.Diagnostics, Severity.Warning);
        if (linked.Chunks.Count == 0) throw new CommandException(CommandFailure.Drawing, Wording.Get("Link.NotWritable"));
        if (await ResultFile.WriteAsync(context, "program", new AgiePost().FileExtension, output => output.Write(linked.Text)).ConfigureAwait(false) is { } name)
        {
            context.Remember(VerifyCommand.Name, name);
            ProgramStart.Save(context.ResolveOutputPath(name), contours[0].Start);
        }

        context.WriteMessage(Wording.Get("Link.Linked", CountText.Format(contours.Sum(contour => contour.Cuts), "Contour"), linked.Text.Count(letter => letter == '\n')), MessageKind.Result);
    }

    private static async Task<AgieContour?> NextAsync(CommandContext context, int taken)
    {
        var answer = await context.AskAsync(new FilePrompt(Wording.Get(taken == 0 ? "Link.EnterFirst" : "Link.EnterNext"), new FileRequest("program", false, new AgiePost().FileExtension)) { EnterEnds = true }).ConfigureAwait(false);
        if (answer is not Answer<string>.Value { Result: var name }) return null;
        var kept = ProgramStart.Find(context.ResolveInputPath(name));
        if (kept.Message is { } unused) context.WriteMessage(unused, MessageKind.Warning);
        var start = await context.ValueAsync(new PointPrompt(Wording.Get("Link.SpecifyStart")) { Default = kept.Position is { } place ? PointPrompt.Format(context.Document.Current.Scale.ToDrawing(place)) : null }).ConfigureAwait(false);
        var (text, fault) = ReadBackFile.Open(context.ResolveInputPath(name)).ReadAll();
        var contour = text is not null ? AgieContour.Read(text, context.Document.Current.Scale.ToMillimetres(start), out fault) : null;
        if (contour is not null) return contour;
        FindingMessages.Write(context, name, [fault!], Severity.Warning);
        throw new CommandException(CommandFailure.Drawing, Wording.Get("Link.NotRead", name));
    }
}
