using System.Text;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Tags;

/// <summary>The variables of the HEADER section that the reader uses.</summary>
internal sealed class DxfHeader
{
    private string _variable = "";

    /// <summary>$ACADVER; "" when the file does not state it.</summary>
    public string Version { get; private set; } = "";

    /// <summary>$DWGCODEPAGE; null when the file does not state it.</summary>
    public string? CodePage { get; private set; }

    /// <summary>$INSUNITS as written; null when missing or not a number.</summary>
    public double? InsUnits { get; private set; }

    /// <summary>$MEASUREMENT as written (0 English, 1 metric); null when missing or not a number. It never scales the drawing.</summary>
    public double? Measurement { get; private set; }

    /// <summary>$LUNITS as written (3 engineering, 4 architectural: feet and inches); null when missing or not a number.</summary>
    public double? DisplayUnits { get; private set; }

    /// <summary>$LTSCALE; 1 when missing or not above 0.</summary>
    public double LinetypeScale { get; private set; } = 1.0;

    /// <summary>$LWDEFAULT, hundredths of a millimetre.</summary>
    public int DefaultLineweight { get; private set; } = Lineweight.UsualDefault;

    /// <summary>Takes one pair of the section: code 9 names a variable, the pairs after it are its values.</summary>
    public void Take(DxfTagSource tag)
    {
        switch (tag.Code)
        {
            case 9:
                _variable = Encoding.Latin1.GetString(tag.Value).Trim();
                break;
            case 1 when _variable == "$ACADVER":
                Version = Encoding.Latin1.GetString(tag.Value).Trim();
                break;
            case 3 when _variable == "$DWGCODEPAGE":
                CodePage = Encoding.Latin1.GetString(tag.Value).Trim();
                break;
            case 40 when _variable == "$LTSCALE":
                if (tag.TryNumber(out var scale) && scale > 0.0) LinetypeScale = scale;
                break;
            case 70 or 370 when _variable == "$LWDEFAULT":
                if (tag.TryNumber(out var weight) && weight is >= 0.0 and <= Lineweight.Heaviest) DefaultLineweight = (int)weight;
                break;
            case 70 when _variable == "$INSUNITS":
                InsUnits = tag.TryNumber(out var unit) ? unit : null;
                break;
            case 70 when _variable == "$LUNITS":
                DisplayUnits = tag.TryNumber(out var display) ? display : null;
                break;
            case 70 when _variable == "$MEASUREMENT":
                Measurement = tag.TryNumber(out var measurement) ? measurement : null;
                break;
        }
    }
}
