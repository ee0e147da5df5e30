namespace Engraver.Core.Drawings;

/// <summary>Lineweights as group 370 states them: hundredths of a millimetre, whatever the unit of the drawing, or one of these values below 0. DXF reference,
/// "Common Group Codes for Entities".</summary>
public static class Lineweight
{
    /// <summary>That of the layer; also of an entity that states none.</summary>
    public const int ByLayer = -1;

    /// <summary>That of the insert.</summary>
    public const int ByBlock = -2;

    /// <summary>That of <see cref="Drawing.DefaultLineweight"/>.</summary>
    public const int Default = -3;

    /// <summary>The default of a drawing that states none, hundredths of a millimetre.</summary>
    public const int UsualDefault = 25;

    /// <summary>The heaviest, hundredths of a millimetre.</summary>
    public const int Heaviest = 211;
}
