using System.Collections.Immutable;

namespace Engraver.Core.Diagnostics;

/// <summary>One row of the table that code, documentation and tests share. Its sentence and its advice are texts of the resources under the id, so that a
/// language may name the facts in another order.</summary>
public sealed record DiagnosticRule
{
    public DiagnosticRule(string id, Severity severity, params ReadOnlySpan<string> factNames) => (Id, Severity, FactNames) = (id, severity, [.. factNames]);

    /// <summary>Permanent: never reused, never renumbered (DXF0007, SEQ0003).</summary>
    public string Id { get; }

    /// <summary>The severity of its findings.</summary>
    public Severity Severity { get; }

    /// <summary>The names in the sentence's braces, in the order in which the facts of a case are given.</summary>
    public ImmutableArray<string> FactNames { get; }

    /// <summary>What happened and where, with {names} for the facts of the case.</summary>
    public string Sentence => Wording.Get(Id);

    /// <summary>What the operator can do. Settings are named by their keys in brackets, [max-error]; the code that shows the finding inserts the option or
    /// command there (docs/settings.md).</summary>
    public string Advice => Wording.Get(Id + ".Advice");

    /// <summary>The finding for one case. <paramref name="facts"/> are in the order of <see cref="FactNames"/>.</summary>
    public Diagnostic At(SourceRef source, params ReadOnlySpan<string> facts) => new(this, source, facts.ToArray());
}
