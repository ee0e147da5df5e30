using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf;

/// <summary>What is wrong with one record. Small, so that a hostile file can have a million of them; the sentence is made only when it is shown.</summary>
/// <param name="Rule">The row of the table; its facts are the type, the place and <paramref name="Detail"/>.</param>
/// <param name="Type">DXF type of the record.</param>
/// <param name="Handle">Handle as a number, 0 for none.</param>
/// <param name="Line">Line (binary: byte offset) at which the record, or what is wrong with it, stands.</param>
/// <param name="Detail">What the sentence needs besides; may be empty.</param>
/// <param name="Refused">True when the record is left out, false when it is taken all the same.</param>
internal readonly record struct Trouble(DiagnosticRule Rule, string Type, ulong Handle, int Line, string Detail, bool Refused)
{
    /// <summary>True when the damage need not be of this record alone, so that it is told even in a block that nothing uses: what has no name may have been the block's end, and all that follows is lost in it.</summary>
    public bool ConcernsMore => Rule == DxfRules.NameDamaged;
}
