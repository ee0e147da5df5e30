namespace Engraver.Core.Dxf.Records;

/// <summary>Distinguishes an unknown type from the damaged name of a type that is cut, where a curve is lost.</summary>
internal static class DamagedName
{
    private static readonly string[] s_cutTypes = ["LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE", "INSERT", "VERTEX"];

    /// <summary>The fault in the name of a record of an unknown type; null for a name that another program may have given.</summary>
    public static string? Fault(string type)
    {
        if (type.Length == 0) return Wording.Get("DamagedName.Empty");
        if (type.Any(letter => char.IsControl(letter) || letter == '\uFFFD')) return Wording.Get("DamagedName.ContainsNonText");
        return s_cutTypes.FirstOrDefault(known => IsNearly(type, known)) is { } meant ? Wording.Get("DamagedName.SimilarTo", meant) : null;
    }

    /// <summary>True when one letter differs, or the end of the name is missing.</summary>
    private static bool IsNearly(string type, string known)
    {
        if (type.Length < known.Length) return known.StartsWith(type, StringComparison.OrdinalIgnoreCase);
        return type.Length == known.Length && type.Zip(known).Count(pair => char.ToUpperInvariant(pair.First) != pair.Second) == 1;
    }
}
