namespace Engraver.Fonts.Finding;

/// <summary>Why a font is not the one that was requested.</summary>
public enum FontTrouble : byte
{
    /// <summary>It is the requested font, or the user's own table replaces that.</summary>
    None,
    NotFound,

    /// <summary>A file of that name exists and cannot be read as a font.</summary>
    Broken,
}
