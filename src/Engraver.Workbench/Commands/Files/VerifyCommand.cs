using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Commands.Files;

/// <summary>VERIFY: Reads a posted program back, runs it in a separate simulated controller, and compares its cut with the open drawing; no machine
/// moves.</summary>
internal sealed class VerifyCommand : ICommand
{
    public const string Name = "VERIFY";

    private const string Origin = "Origin";
    private const string Blend = "Blend";
    private const string Target = "Target";

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List(Origin, Blend, Target);
    private static readonly IReadOnlyList<PostChoice> s_readable = [.. PostTable.Choices.Where(choice => choice.Reader is not null)];
    private static readonly IReadOnlyList<Keyword> s_targets = Keyword.List([.. s_readable.Select(choice => choice.Keyword)]);

    public CommandInfo Info { get; } = new(Name, CommandGroup.Output);

    /// <exception cref="CommandException">The program does not cut exactly the drawing.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        var (name, chosen, posted) = await AskAsync(context).ConfigureAwait(false);
        context.Remember(Name, name);
        var file = context.ResolveInputPath(name);
        var (target, program) = (chosen ?? ProgramFormatDetector.Of(file) ?? s_readable[0], ReadBackFile.Open(file));
        var kept = ProgramStart.Find(file);
        if (kept.Message is { } unused) context.WriteMessage(unused, MessageKind.Warning);
        posted = posted with { Start = kept.Position };
        if (chosen is null) context.WriteMessage(Wording.Get("Verify.ReadAs", name, target.Name));
        var report = await ReadBackProgress.ShowAsync(context.Progress, progress => ProgramVerification.VerifyAsync(program, target.Reader!, drawing, settings, progress, cancellation, posted), cancellation).ConfigureAwait(false);
        report = CertifiedFonts.Compare(report, drawing, settings, target.Entry.Post.Name, target.Dialect);
        if (context.History.NoteReadBack(file, new HistoryReadBack(report.Ok, context.Time.GetUtcNow(), report.MaxDeviationMm, Certificate: null)) is { } failure) context.WriteMessage(Wording.Get("History.NotKept", failure), MessageKind.Warning);
        FindingMessages.Write(context, drawing.FileName, drawing.Diagnostics, Severity.Error);
        FindingMessages.Write(context, name, report.Diagnostics, Severity.Warning);
        context.WriteMessage(VerificationText.Sentence(report), MessageKind.Result);
        if (!report.Ok) throw new CommandException(CommandFailure.Drawing, Wording.Get("Verify.DoesNotMatch", name));
    }

    /// <summary>Asks for the program, and before its name for the post parameters other than the drawing's settings.</summary>
    private static async Task<(string Name, PostChoice? Target, PostParameters Posted)> AskAsync(CommandContext context)
    {
        var (posted, target) = (PostParameters.Defaults, (PostChoice?)null);
        var prompt = new FilePrompt(Wording.Get("Verify.EnterName"), new FileRequest("program", false, PostTable.ReadableExtensions) { Suggested = context.LastValue(Name) is { } last ? Path.GetFullPath(context.ResolveInputPath(last)) : null }) { Default = context.LastValue(Name), Options = s_options };
        while (true)
        {
            switch (await context.AskAsync(prompt).ConfigureAwait(false))
            {
                case Answer<string>.Value { Result: var name }: return (name, target, posted);
                case Answer<string>.SelectedOption { Option: Origin }:
                    var place = await context.ValueAsync(new MachinePositionPrompt(Wording.Get("Verify.SpecifyOrigin")) { AllowsZ = true }).ConfigureAwait(false);
                    posted = posted with { Origin = new ProgramOrigin(place.X, place.Y, place.Z) };
                    break;
                case Answer<string>.SelectedOption { Option: Target }:
                    var keyword = await context.ChoiceAsync(Wording.Get("Verify.EnterTarget"), s_targets, s_readable[0].Keyword).ConfigureAwait(false);
                    target = s_readable.First(choice => choice.Keyword == keyword);
                    break;
                default:
                    posted = posted with { BlendMm = await context.ValueAsync(new NumberPrompt(Wording.Get("Verify.SpecifyBlend")) { Min = 0.0, Max = 1.0 }).ConfigureAwait(false) };
                    break;
            }
        }
    }
}
