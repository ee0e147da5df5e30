using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>A second calculation of the places of the letters of a text, with which <see cref="LetterCheck"/> compares what is cut.</summary>
internal interface ILetterPlaces
{
    /// <summary>The characters that have a shape.</summary>
    IReadOnlyList<LetterPlaces.Letter> Letters { get; }

    /// <summary>A point of each line that is drawn with the letters, in the drawing, by its fraction.</summary>
    IEnumerable<Func<double, Vector3D>> LineCurves { get; }

    /// <summary>A point of the text in the drawing.</summary>
    Vector3D Origin { get; }

    /// <summary>Length or height of the text in the drawing, whichever is larger.</summary>
    double Size { get; }

    /// <summary>Largest number that the calculation adds: its rounding is in every coordinate.</summary>
    double LargestTerm { get; }

    /// <summary>A point of a letter in the drawing.</summary>
    Vector3D At(LetterPlaces.Letter letter, double fontX, double fontY);
}
