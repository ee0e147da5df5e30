namespace Engraver.Core.Diagnostics;

/// <summary>One row of the table that code, documentation and tests share.</summary>
/// <param name="Id">Permanent: never reused, never renumbered (DXF0007, SEQ0003).</param>
/// <param name="Severity">How bad it is.</param>
/// <param name="Sentence">What and where, with {names} for the facts of the case.</param>
/// <param name="Advice">What the operator can do.</param>
public sealed record DiagnosticRule(string Id, Severity Severity, string Sentence, string Advice)
{
    /// <summary>The finding for one case. <paramref name="facts"/> fill the {names} of the sentence in the order in which they first appear.</summary>
    public Diagnostic At(SourceRef source, params ReadOnlySpan<string> facts) => new(this, source, facts.ToArray());
}
