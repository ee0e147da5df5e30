using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Tags;

namespace Engraver.Core.Dxf.Text;

/// <summary>Reads the columns of an MTEXT from the place where its release writes them. DXF reference, "MTEXT"; the names in the extended data are those that
/// AutoCAD writes.</summary>
internal static class TextColumnReader
{
    private const int NoColumns = 0;

    /// <summary>The columns, null for none, and the defined height, 0 where it is not stated.</summary>
    public static (TextColumns? Columns, double DefinedHeight) Read(EntityRecord record)
    {
        if (record.Embedded.Count > 0) return Embedded(record.Embedded);
        var isDirect = record.Sequence.Exists(pair => pair.Code == 75);
        return record.Extended.Count > 0 && !isDirect ? Extended([.. record.ExtendedOf("ACAD")]) : (isDirect ? Direct(record.Sequence) : null, 0.0);
    }

    /// <summary>The object that releases from 2018 on embed: 71 type, 72 count, 74 reversed, 73 automatic height, 44 width, 45 gutter, 46 heights, 41 defined
    /// height.</summary>
    private static (TextColumns? Columns, double DefinedHeight) Embedded(List<CodedNumber> numbers)
    {
        var columns = new TextColumns
        {
            Type = First(numbers, 71),
            Count = First(numbers, 72),
            IsFlowReversed = First(numbers, 74) != 0,
            IsAutoHeight = First(numbers, 73) != 0,
            Width = Value(numbers, 44),
            Gutter = Value(numbers, 45),
            Heights = All(numbers, 46),
        };
        return (columns.Type == NoColumns ? null : columns, Value(numbers, 41));
    }

    /// <summary>Groups 75, 76, 78, 79, 48, 49 and 50 of the record; only a 50 after the 75 is a height.</summary>
    private static TextColumns? Direct(List<CodedNumber> all)
    {
        var numbers = all[all.FindIndex(pair => pair.Code == 75)..];
        var columns = new TextColumns
        {
            Type = First(numbers, 75),
            Count = First(numbers, 76),
            IsFlowReversed = First(numbers, 78) != 0,
            IsAutoHeight = First(numbers, 79) != 0,
            Width = Value(numbers, 48),
            Gutter = Value(numbers, 49),
            Heights = All(numbers, 50),
        };
        return columns.Type == NoColumns ? null : columns;
    }

    /// <summary>Extended data: between names that begin and end a part, a 1070 states the group code of the value after it. After code 50 the number of
    /// heights comes first, after code 47 the number of linked records.</summary>
    private static (TextColumns? Columns, double DefinedHeight) Extended(List<ExtendedValue> values)
    {
        var (numbers, handles, height) = (new List<CodedNumber>(), new List<ulong>(), 0.0);
        var part = "";
        for (var at = 0; at < values.Count; at++)
        {
            var value = values[at];
            if (value.Code == 1000) part = value.Text.Trim();
            else if (part == "ACAD_MTEXT_COLUMNS_BEGIN" && value.Code == 1005) handles.Add(HandleText.Parse(System.Text.Encoding.ASCII.GetBytes(value.Text)));
            else if (part == "ACAD_MTEXT_COLUMN_INFO_BEGIN" && value.Code == 1040) numbers.Add(new CodedNumber(50, value.Number));
            else if (value.Code != 1070 || at + 1 == values.Count || values[at + 1].Code is not (1040 or 1070)) continue;
            else if (part == "ACAD_MTEXT_DEFINED_HEIGHT_BEGIN" && value.Number == 46.0) height = values[++at].Number;
            else if (part == "ACAD_MTEXT_COLUMN_INFO_BEGIN" && values[++at] is var stated && value.Number != 50.0) numbers.Add(new CodedNumber(value.Whole, stated.Number));
        }

        return (numbers.Exists(number => number.Code == 75) ? Direct([.. numbers.OrderBy(number => number.Code == 75 ? 0 : 1)]) is { } columns ? columns with { LinkedHandles = handles } : null : null, height);
    }

    private static int First(List<CodedNumber> numbers, int code) => Value(numbers, code) is var value && Math.Abs(value) <= int.MaxValue ? (int)value : 0;

    private static double Value(List<CodedNumber> numbers, int code)
    {
        foreach (var number in numbers)
        {
            if (number.Code == code) return number.Value;
        }

        return 0.0;
    }

    private static double[] All(List<CodedNumber> numbers, int code) => [.. numbers.Where(number => number.Code == code).Select(number => number.Value)];
}
