using Engraver.Core.Drawings;

namespace Engraver.Cli.Output;

/// <summary>What <c>engraver info --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record InfoJson(
    string File,
    long Bytes,
    string DxfVersion,
    string Encoding,
    InfoJson.UnitsJson Units,
    IReadOnlyDictionary<string, int> Entities,
    InfoJson.BalanceJson Balance,
    InfoJson.PrimitivesJson Primitives,
    IReadOnlyDictionary<string, int> Leaf,
    IReadOnlyDictionary<string, int> Text,
    InfoJson.LengthJson Length,
    InfoJson.BoundsJson? Bounds,
    IReadOnlyList<InfoJson.LayerJson> Layers,
    IReadOnlyList<DiagnosticJson> Diagnostics,
    IReadOnlyList<InfoJson.TextJson> Texts)
{
    internal sealed record UnitsJson(int Code, string Name, string Source, double ToMillimetres);

    internal sealed record RefusedJson(string Type, string? Handle, long Line, string Id, string Reason)
    {
        public static RefusedJson From(RefusedEntity refused) => new(refused.Type, refused.Handle, refused.Line, refused.DiagnosticId, refused.Reason);
    }

    internal sealed record BalanceJson(int Read, int Cut, int Construction, IReadOnlyList<RefusedJson> Refused, IReadOnlyList<RefusedJson> RefusedInBlocks);

    internal sealed record PrimitivesJson(int Line, int Arc, int Circle, int Ellipse, int Spline, int Polyline, int Point);

    internal sealed record LengthJson(double Line, double Arc, double Circle, double Ellipse, double Spline, double Total, double PlanTotal);

    internal sealed record BoundsJson(double MinX, double MinY, double MaxX, double MaxY);

    /// <summary>A text with its position in drawing units; <c>column</c> and <c>row</c> are its alignment.</summary>
    internal sealed record TextJson(
        string Type, string Content, double X, double Y, double Height, double Rotation, double WidthFactor, bool Mirrored, string Column, string Row, string Style, string Font, string Layer, bool Hidden, string? Handle, long Line);

    internal sealed record LayerJson(string Name, bool On, bool Frozen, bool Plot, bool Locked, int Entities);
}
