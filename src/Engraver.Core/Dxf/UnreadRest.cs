namespace Engraver.Core.Dxf;

/// <summary>
/// What follows the place where reading a binary file stopped. AutoCAD's vertical products (Map, Civil) have objects of their own whose values are not as long as their group codes say,
/// so that nothing behind such a value can be found again; AutoCAD reads it, for it calls the object's own code.
/// </summary>
internal static class UnreadRest
{
    /// <summary>True when damage stopped the reading of a file that is whole (EOF stands in it) and all its sections of entities and definitions lie ahead of the damage.</summary>
    public static bool IsHarmless(DxfTagSource tags)
    {
        if (!tags.IsBinary || tags.DamageCount == 0 || tags.LastWord("EOF"u8) < tags.DamageLine) return false;
        return Math.Max(tags.LastWord("ENTITIES"u8), Math.Max(tags.LastWord("BLOCKS"u8), tags.LastWord("TABLES"u8))) < tags.DamageLine;
    }
}
