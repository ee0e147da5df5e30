namespace Engraver.Simulator.Language;

/// <summary>Where a subroutine or an automatic subroutine goes back to.</summary>
/// <param name="Interrupt">True for an automatic subroutine, which may restore the trippoint it interrupted.</param>
internal readonly record struct CallFrame(int Line, int Part, bool Interrupt, Trippoint? Trippoint);
