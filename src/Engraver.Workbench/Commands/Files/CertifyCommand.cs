using Engraver.Core.Diagnostics;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Files;

/// <summary>CERTIFY: Reads the program of the drawing back, compares both, and writes the certificate beside the drawing; no machine moves.</summary>
internal sealed class CertifyCommand : ICommand
{
    private const string Name = "CERTIFY";

    private static readonly IReadOnlyList<PostChoice> s_readable = [.. PostTable.Choices.Where(choice => choice.Entry.Reader is not null)];
    private static readonly IReadOnlyList<Keyword> s_targets = Keyword.List([.. s_readable.Select(choice => choice.Keyword)]);

    public CommandInfo Info { get; } = new(Name, CommandGroup.Output);

    /// <exception cref="CommandException">The drawing has unsaved edits, there is no program, or the program differs from the drawing.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var file = context.Drawing.FileName;
        if (context.Document.IsDrawingEdited || context.Document.FilePath != file) throw new CommandException(CommandFailure.Usage, Wording.Get("Certify.Edited"));
        var usual = (PostTable.ForMotion(context.Driver, context.Derivation.Strategy.Style) ?? PostTable.All[0]).Keyword;
        var keyword = await context.ChoiceAsync(Wording.Get("Certify.EnterTarget"), s_targets, context.LastValue(Name, usual)).ConfigureAwait(false);
        context.Remember(Name, keyword);
        var made = await ReadBackProgress.ShowAsync(context.Progress, progress => Certification.CertifyAsync(Request(context, file, s_readable.First(choice => choice.Keyword == keyword), cancellation), progress, cancellation), cancellation).ConfigureAwait(false);
        FindingMessages.Write(context, file, made.Diagnostics, Severity.Warning);
        if (made.Certificate is not { } certificate) throw new CommandException(CommandFailure.Drawing, $"{made.NoProgramReason}.");
        if (!certificate.Ok) throw new CommandException(CommandFailure.Drawing, Wording.Get("Certify.NotOk", Path.GetFileName(file), certificate.MissingLength, certificate.ExtraLength));
        var place = CertificateFile.PathOf(file, certificate.Program.Target, certificate.Program.Dialect);
        CertificateFile.Write(place, certificate);
        context.WriteMessage(Wording.Get("Certify.Written", Path.GetFileName(place), certificate.MaxDeviation ?? 0.0, certificate.Tolerance), MessageKind.Result);
        await CheckAsync(context, cancellation).ConfigureAwait(false);
    }

    /// <summary>The drawing is read again, because the file is certified.</summary>
    private static CertificationRequest Request(CommandContext context, string file, PostChoice target, CancellationToken cancellation)
    {
        var (settings, hash) = (context.Document.Current.Settings, ContentHash.OfFile(file));
        var drawing = DrawingFile.Open(file, settings, cancellation);
        return new CertificationRequest(drawing, hash, settings, target.Entry, context.Time.GetUtcNow()) { Dialect = target.Dialect, Address = context.Machine.Connection.Line, Strategy = context.Derivation.Strategy, Values = context.PlateValues };
    }

    /// <summary>Updates the start checks.</summary>
    private static async Task CheckAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Derivation.Current is { Job: { Motion.Program: { } program } job } derived) await context.Certificates.CheckAsync(job, JobPlan.FitToLink(program, derived.Line, derived.Strategy, job.Drawing).Program, cancellation).ConfigureAwait(false);
    }
}
