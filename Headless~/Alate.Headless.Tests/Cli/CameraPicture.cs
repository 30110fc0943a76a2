using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Alate.Formats;

namespace Alate.Tests.Cli
{
    /// <summary>
    /// A wing of 120 × 72 pixels as cameras save it, written by cjpeg of libjpeg-turbo 2.1, quality 60: hinge at the left, leading edge up.
    /// </summary>
    internal static class CameraPicture
    {
        private static readonly Dictionary<string, string> s_Files = new()
        {
            ["base"] = """
                /9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQYEpRUk//
                2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT0//wAARCABIAHgDASIAAhEBAxEB/8QA
                GwABAAIDAQEAAAAAAAAAAAAAAAEFAgQGAwf/xAA1EAABAwIDBQUHAwUAAAAAAAABAAIDBBEFEjEGFCFRcRNBUlOhFWGBkaKx0SIy8BZUksHS/8QAGQEAAwEB
                AQAAAAAAAAAAAAAAAAIDAQQF/8QAIxEAAwABBAEEAwAAAAAAAAAAAAECAwQRITETEhRBUSIyQv/aAAwDAQACEQMRAD8A+joiJQCIiACLwrK2loY89VM2MHS+
                p6DU6qnqtrKGLMKeOWdwtY2ytPxPH0S1cz2x5x1XSL9FyE+2FQ7Lu9JEzxZ3F9/lay8f6vxHyaX/ABd/0k88FPb2dqi42HbGra8mopYXttwDCWG/U3W9TbYU
                b7Cpp5YSXWu0h7QOZ0PotWaH8ivDa+DpEWpQ4nQ4hfdKhkhbq3iHdbHjbjqttUTT6JNbdhERABERABEVbjOLxYZDYWfUPH6Gf7Pu+/2yqUrdjTLt7I2K/EKb
                D4hJUyZc18rQLlxHIfwLlMR2lrKiRzaR3YQ8QLAZiPee49OaqJ5paid807y+R5u5x715LhvPVdcI9LHpZjl8sPc573Pe4uc43JJuSViVJUFSLMhYlZLErSbI
                KhSVC0mzEq5oNp8SpHNEku8xDVsvE63/AHa3636KmKgp5prolST7PpmF4zRYoCKZ5EjRd0bxZwF7X5H4cwt9fJGPdG9r2OLXNN2uBsQea73ZvaBuJMFNVENr
                GjoJRzHv5j4j3dWPL6uGc1xtyi+REVSYXzvEZ31tfPUcSHuJbewIboB8rL6IqDFtn+2kfUUTrSPcXPY48Cfced+fPuXPqIqp/E6NPlWNs5Hs38lHZP8AD6ra
                fG+KQslY5jxq1wsQgXnepo7Xmo1exk8Pqo3eXw+oW4FkFnkYjys0d2m8HqFG6z+D1CsQpCPKxXkZW7pP5fqFG51Hl/UFahZBZ5qEeRlRuNT5f1BRuFV5X1D8
                q5CyCz3FCO2Uns+r8r6h+VlDR18M0c0UeWSNwc05mmxBuFdtBc4NaCSTYAd6uaDBi8CSru1pFwwa/Hl/NFTHky5HtKJuy5hkE0EcoaWh7Q4A6i470WaL2CIR
                EQB41VJT1bMlTE2QDS+o6HUaKkqdmG2vSVBBt+2UanqPwuhRTvFF/shpup6OJlwnEIcuelkN/AM32utQL6CvOWCGe3bQxyZdM7QbfNc1aJfyyizfaOECkLsZ
                cJoJXZnUzAQLfpu0fILH2Lh39v8AW78qL0V/aN8qOSCyC62PCaCN4c2maSPES4fIlbMdPBC7NFDGxxFrtaAULQ0+2K8iOTgoKue3Z07yCLgkWBHUqzpcBcQH
                VUuXmxnE6c1eorxosc8vkV22eFLR09I20MYBtYuPEn4r3RF1zKlbIQIiLQCIiACIiACIiACIiACIiACIiACIiACIiAP/2Q==
                """,
            ["progressive"] = """
                /9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQYEpRUk//
                2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT0//wgARCABIAHgDASIAAhEBAxEB/8QA
                GgABAAMBAQEAAAAAAAAAAAAAAAEEBQMCBv/EABgBAQEBAQEAAAAAAAAAAAAAAAABAgME/9oADAMBAAIQAxAAAAH6MQAeKct9keM62mN3s0nLrrIAArS9Mqn5
                4elBncRMMomLmLtJcfTd/kt7rzvjeXzv0VDn0yI6vN25O0pwiySstTM1IuylGb1zWbqXswB4paDNxOX0HnlrCbMYZE6/RMm1edJ49nWBQAAAAAAAH//EACEQ
                AAICAgICAwEAAAAAAAAAAAECAAMEEhEgEzAQFEAx/9oACAEBAAEFAvxu6oGy0EOY0+3ZBmNFzEiWJZ3exaxZkux7pk2LKrkt6XWisElj6f5MbI8nzYd34nE4
                M1M1M1M1M0aaNNGnjaBHBB5Etx+TxwfUlPRlVo2NDVYOwRjFoioq+ggGGpDPDXBUggUD8v8A/8QAHREAAgICAwEAAAAAAAAAAAAAAAEREgIQAxMgMP/aAAgB
                AwEBPwHSxbOtlH4Skx4kvDGtceVS7LFixJO02i5YsT8//8QAIBEAAgEDBAMAAAAAAAAAAAAAAAECAxESEBMgMSEwUf/aAAgBAgEBPwHRtIzRmuDdhzb4JkZX
                0qJteC5kZGbNxkZSl1q4p9jo/DZZsMVGKErer//EACUQAAIABQMDBQAAAAAAAAAAAAABAhEhIjEgMDIQEkBRYWKRsf/aAAgBAQAGPwLw7nItTZbCjEJdCi6F
                otinrnEy2i2KvuXuW59NHyJvO32xc/3q4teDBgwYE0qoT6d0GSu3OLRcplsX2cXqpCXMotiqTOJxOJRLxf/EACgQAQACAAQEBQUAAAAAAAAAAAEAESExUWEQ
                IEHwMEBxgdGRobHB8f/aAAgBAQABPyHydmOLqx+hGVS1tufy35hXFm2ERqPTEmXVOnXnwgLyNYgH+eKqq2vO+egfKZgwZrPk1WsiOXtZvhCoRpMmAckcS6s4
                ektLaTamxNmbfDdhncZ3mdplXRLMSYWVZfC6TE2jFUBHR8IxaJd0TTkNoIH9UUt+1jzZ+R86tiE/e8Do+akWtHthO4sWsHvjE7E7Hlf/2gAMAwEAAgADAAAA
                EPPMc/dPPPqiPlK1vOH4FL0NDPLLk97XvPPPPPPPPP/EABwRAQEAAwEAAwAAAAAAAAAAAAEAEBExITBBUf/aAAgBAwEBPxDHAMKP1JruUei9F9ZmYD21+mBT
                MLlSpc58SP0WsiW/H//EAB0RAQACAgIDAAAAAAAAAAAAAAEAMRARIUEgMFH/2gAIAQIBAT8QxaOMXuCNZAbZWcHghUpOUNibTfIJaGa9B7R+5BLZzjzAGj1f
                /8QAKBABAAIBAgUDBAMAAAAAAAAAAQARMVHwECFhcYFBkdEgQKGxMMHh/9oACAEBAAE/EPs6RBxeXsZcyhBqpqzy8/xPMHV/aq4YFrQuQ133blSNNLQRq4fx
                LS6y5jup51zz9ZXKKC1GhsmcFBQWOr6PbWM2RaraseDHgw0p881zfVfe+0GRwLDQLq9HxqfRXii/7vT9/prbbT14MeDHgxjlkWDSOsAsA7B1Oup5OnDn+Rm1
                CYB7VOjN5mwzaSbqTbSbyTYE2hN0fM2x8yiECWUjZAFQIDks9eHIKUtyXo63rr6Rsd5CkhCEIQhCECAKrQHrHJahYc+dN4+il8MXk7OTErWw1hy9z4nOEvT/
                AEuEIQhK+yJYpQndiA6lz3GsoQDVK5r5/grdAVNe8qxoVkPYm180CpJqR7LLIkVYD9r/AP/Z
                """,
            ["grey"] = """
                /9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQYEpRUk//
                wAALCABIAHgBAREA/8QAGwABAAIDAQEAAAAAAAAAAAAAAAECAwQFBgf/xAA1EAABAwIDBQUHAwUAAAAAAAABAAIDBBEFEjEGFCFRcRNBUlOhFWGBkaKx0SIy
                8BZUksHS/9oACAEBAAA/APo6IiIiIiIiIiIiwVlbS0MeeqmbGDpfU9BqdVx6rayhizCnjlncLWNsrT8Tx9Fz59sKh2Xd6SJnizuL7/K1lh/q/EfJpf8AF3/S
                vDtjVteTUUsL224BhLDfqbreptsKN9hU08sJLrXaQ9oHM6H0XZocTocQvulQyQt1bxDutjxtx1W2iIiLVr8QpsPiElTJlzXytAuXEch/AvKYjtLWVEjm0juw
                h4gWAzEe89x6c1w3uc97nvcXOcbkk3JKqVCqVBUKpXZoNp8SpHNEku8xDVsvE63/AHa3636L2WF4zRYoCKZ5EjRd0bxZwF7X5H4cwt9EXNxnF4sMhsLPqHj9
                DP8AZ933+3hZ5paid807y+R5u5x71iUFQVCqVBUKpUFGPdG9r2OLXNN2uBsQea97s3tA3EmCmqiG1jR0Eo5j38x8R7u8i+d4jO+tr56jiQ9xLb2BDdAPlZa3
                Zv5KOyf4fVOxk8Pqo3eXw+oTdpvB6hRus/g9Qm6T+X6hRudR5f1BNxqfL+oKNwqvK+oflPZ9X5X1D8q0NHXwzRzRR5ZI3BzTmabEG4X02GQTQRyhpaHtDgDq
                LjvV1wMW2f7aR9RROtI9xc9jjwJ9x5358+5eafG+KQslY5jxq1wsQgUhWCsFIVgrBSFYKzQXODWgkk2AHeuzQYMXgSVd2tIuGDX48v5ou4iLDVUlPVsyVMTZ
                ANL6jodRouJU7MNtekqCDb9so1PUfhcqXCcQhy56WQ38Azfa61ArBSFYKwW1BQVc9uzp3kEXBIsCOpXTpcBcQHVUuXmxnE6c11qWjp6RtoYwDaxceJPxWdER
                ERY5YIZ7dtDHJl0ztBt81rS4TQSuzOpmAgW/Tdo+QVfYuHf2/wBbvyrR4TQRvDm0zSR4iXD5ErZjp4IXZooY2OItdrQCsiIiIiIiIiIiIiL/2Q==
                """,
        };

        /// <summary>The file of a kind: base, progressive or grey.</summary>
        public static byte[] Of(string kind) => Convert.FromBase64String(s_Files[kind]);

        /// <summary>Remarks of a camera about a picture: a TIFF file of two entries, of which the second is the orientation.</summary>
        public static byte[] Exif(int orientation, bool little)
        {
            byte[] exif = new byte[8 + 2 + 2 * 12 + 4];
            Encoding.ASCII.GetBytes(little ? "II" : "MM").CopyTo(exif, 0);
            void Short(int at, int value)
            {
                if (little)
                    BinaryPrimitives.WriteUInt16LittleEndian(exif.AsSpan(at), (ushort)value);
                else
                    BinaryPrimitives.WriteUInt16BigEndian(exif.AsSpan(at), (ushort)value);
            }

            Short(2, 42);
            Short(little ? 4 : 6, 8);
            Short(8, 2);
            Short(10, 0x0100);
            Short(22, 0x0112);
            Short(24, 3);
            Short(little ? 26 : 28, 1);
            Short(30, orientation);
            return exif;
        }

        /// <summary>A JPEG or PNG file with what the camera says of it.</summary>
        public static byte[] WithExif(byte[] file, byte[] exif)
        {
            var all = new MemoryStream();
            if (file[0] == 0xFF)
            {
                all.Write([0xFF, 0xD8, 0xFF, 0xE1, 0, (byte)(exif.Length + 8), .. "Exif\0\0"u8, .. exif]);
                all.Write(file.AsSpan(2));
            }
            else
            {
                // Behind the header, which has 25 bytes.
                int header = PngChunks.Signature.Length + 25;
                all.Write(file.AsSpan(0, header));
                PngChunks.Write(all, "eXIf", exif);
                all.Write(file.AsSpan(header));
            }

            return all.ToArray();
        }
    }
}
