using Engraver.App.Texts;
using Engraver.Core.Diagnostics;

namespace Engraver.App.Findings;

/// <summary>A finding of the drawing doctor.</summary>
public sealed class FindingRow(Diagnostic diagnostic)
{
    public Diagnostic Diagnostic => diagnostic;

    public string Severity => Text.Of("Severity." + diagnostic.Severity);

    public string Id => diagnostic.Id;

    public string Place => diagnostic.Source.Line == 0 ? "" : FormattableString.Invariant($"{diagnostic.Source.Line}");

    public string Handle => diagnostic.Source.Handle ?? "";

    public string Message => diagnostic.Message;

    public bool IsError => diagnostic.Severity == Core.Diagnostics.Severity.Error;

    public bool IsWarning => diagnostic.Severity == Core.Diagnostics.Severity.Warning;
}
