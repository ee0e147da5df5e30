using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf;

/// <summary>What an INSERT hands down to the content of its block.</summary>
/// <param name="Layer">The layer that counts: for content on layer 0.</param>
/// <param name="Hidden">It, or one around it, is invisible or on a frozen layer.</param>
/// <param name="Colour">For content that is coloured by block; by layer: that of <paramref name="Layer"/>.</param>
internal readonly record struct InsertStyle(int Layer, bool Hidden, DrawingColour Colour);
