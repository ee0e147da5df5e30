using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.SerialTexts;

/// <summary>Why a field is not filled.</summary>
/// <param name="Reason">Without a full stop; "" for brackets that are not a field.</param>
public sealed record FieldProblem(SerialField Field, string Reason)
{
    /// <summary>As a finding about a text of the drawing.</summary>
    public Diagnostic At(SourceRef source) => Field switch
    {
        SerialField.Brackets => SerialRules.NotAField.At(source, Field.Written),
        SerialField.Invalid => SerialRules.InvalidField.At(source, Field.Written, Reason),
        _ => SerialRules.NoValue.At(source, Field.Written, Reason),
    };
}
