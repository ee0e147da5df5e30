using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf.Records;

/// <summary>A finding about one record. Small, because a malicious file can have a million of them; the sentence is composed only when it is shown.</summary>
/// <param name="Rule">The row of the table; its facts are the type, the position and <paramref name="Detail"/>.</param>
/// <param name="Type">DXF type of the record.</param>
/// <param name="Handle">Handle as a number, 0 for none.</param>
/// <param name="Line">Line (binary: byte offset) of the record, or of the part that is wrong.</param>
/// <param name="Detail">Further text for the sentence; may be empty.</param>
/// <param name="Refused">True when the record is left out, false when it is accepted nevertheless.</param>
internal readonly record struct RecordIssue(DiagnosticRule Rule, string Type, ulong Handle, int Line, string Detail, bool Refused)
{
    /// <summary>True when the damage may affect more than this record, so that it is reported even in an unused block: the nameless record may have been the
    /// block's end, and all records that follow are then in the block.</summary>
    public bool ConcernsMore => Rule == DxfRules.NameDamaged;
}
